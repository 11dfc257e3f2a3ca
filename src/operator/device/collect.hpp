// The tiles of an evaluation, one launch for each list of terms, and what they have summed as control values, one
// launch in all.
#pragma once

#include <cstring>

#include "field/layout.hpp"
#include "operator/device/tile_launch.hpp"

namespace softwet {

/// The tiles of one term: partial[tile][channel][control of the tile].
template <int D, class Real>
struct TileSource {
  const Real* partial = nullptr;
  Kokkos::View<const int*, Exec> first_row;  ///< of the control points of its test functions, by layer of elements
  int first[D] = {};                         ///< control point of the first tile along the other axes
  int tiles[D] = {}, width[D] = {}, across[D] = {};
  bool shared_test = false;  ///< all tiles along the last axis have the same control points
  int channels = 0;
  int channel_of[D + 2] = {};  ///< of the component; -1: none

  template <class Shape>
  void shape(const TileGrid<D>& grid) {
    for (int d = 0; d < D; ++d) {
      if (d < D - 1) first[d] = grid.first[d];
      tiles[d] = grid.tiles[d];
      width[d] = Shape::width(d);
      across[d] = width[d] + Shape::P;
    }
    across[D - 1] = Shape::planes;
  }

  /// Sum over the tiles that hold control point `at`, of a component with channel c; in the order of the tiles.
  KOKKOS_FUNCTION Real sum(const int (&at)[D], int c) const {
    int low[D], high[D], local[D];
    for (int d = 0; d < D; ++d) {
      local[d] = at[d] - (d == D - 1 ? first_row(0) : first[d]);
      if (d == D - 1 && shared_test) {
        low[d] = 0;
        high[d] = local[d] >= 0 && local[d] < across[d] ? tiles[d] - 1 : -1;
        continue;
      }
      const int begin = local[d] - across[d] + width[d];
      low[d] = begin > 0 ? begin / width[d] : 0;
      high[d] = local[d] < 0 ? -1 : local[d] / width[d];
      if (high[d] >= tiles[d]) high[d] = tiles[d] - 1;
    }
    Real total = 0;
    for (int z = low[D - 1]; z <= high[D - 1]; ++z)
      for (int y = D == 3 ? low[1] : 0; y <= (D == 3 ? high[1] : 0); ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const int tile = ((D == 3 ? z * tiles[1] + y : z)) * tiles[0] + x;
          int place = local[D - 1] - (shared_test ? 0 : z * width[D - 1]);
          if constexpr (D == 3) place = place * across[1] + local[1] - y * width[1];
          place = place * across[0] + local[0] - x * width[0];
          const int controls = across[0] * across[D - 1] * (D == 3 ? across[1] : 1);
          total += partial[(std::int64_t(tile) * channels + c) * controls + place];
        }
    return total;
  }
};

/// One thread for each entry of the vector.
template <int D, class Real>
struct CollectTiles {
  TileSource<D, Real> source[most_sources];
  int sources = 0;
  int extent[D - 1] = {}, row_size = 0;
  int components = 0, offset[D + 2] = {}, first_row[D + 2] = {};
  ArrayOf<Real> out;
  ConstArray mask;   ///< empty: none
  bool add = false;  ///< whether sums are added to the values of `out`

  KOKKOS_FUNCTION void operator()(int entry) const {
    const Real total = added_to(add ? out(entry) : Real(0), entry);
    out(entry) = mask.data() ? static_cast<Real>(mask(entry)) * total : total;
  }
  /// The sum of a number and of what the tiles have for an entry of the vector.
  KOKKOS_FUNCTION Real added_to(Real total, int entry) const {
    if (sources == 0) return total;
    int c = components - 1;
    while (entry < offset[c]) --c;
    int rest = entry - offset[c], at[D];
    at[D - 1] = rest / row_size + first_row[c];
    rest %= row_size;
    at[0] = rest % extent[0];
    if constexpr (D == 3) at[1] = rest / extent[0];
    for (int s = 0; s < sources; ++s)
      if (source[s].channel_of[c] >= 0) total += source[s].sum(at, source[s].channel_of[c]);
    return total;
  }
};

/// In the place of these sums on the host, where terms add to the vector themselves.
struct NoTiles {
  KOKKOS_FORCEINLINE_FUNCTION double added_to(double total, int) const { return total; }
};
template <int D>
using TileSumsOf = std::conditional_t<host_algorithms, NoTiles, CollectTiles<D, double>>;

/// How often rooms of `tile_room` have moved.
inline long moves_of_tile_rooms = 0;

/// Room for the partial sums of one term; grown when needed, released before Kokkos ends.
template <class Real>
Real* tile_room(int term, std::size_t size) {
  static std::vector<ArrayOf<Real>> rooms;
  if (rooms.empty()) {
    rooms.resize(most_sources);
    Kokkos::push_finalize_hook([] { rooms.clear(); });
  }
  if (rooms[term].extent(0) < size) {
    rooms[term] = ArrayOf<Real>(Kokkos::view_alloc("tiles", Kokkos::WithoutInitializing), size);
    ++moves_of_tile_rooms;
  }
  return rooms[term].data();
}

/// The terms of one evaluation that are computed in tiles. On the host there are none. Their tables have to be there
/// until the sums are asked for. Partial sums have one place for all evaluations, so that these follow each other.
template <int D, class Real>
class TileSums {
 public:
  /// @param direction  that a product multiplies
  explicit TileSums(const Layout<D>& layout, const ConstArrayOf<Real>& direction = {}) : direction_(direction) {
    collect_.sources = 0;
    for (int d = 0; d < D - 1; ++d) collect_.extent[d] = layout.extent(d);
    collect_.row_size = layout.row_size;
    collect_.components = layout.components();
    for (int c = 0; c < layout.components(); ++c) {
      collect_.first_row[c] = layout.component_first(c) / layout.row_size;
      collect_.offset[c] = layout.component_shift(c) + layout.component_first(c);
    }
  }

  /// A further term, of so many partial sums.
  template <class Test>
  TileSource<D, Real>& add(std::size_t size) {
    if (collect_.sources == most_sources) throw std::logic_error("more terms than an evaluation has room for");
    TileSource<D, Real>& s = collect_.source[collect_.sources];
    s = {};
    s.partial = tile_room<Real>(collect_.sources, size);
    s.channels = Test::channel_count;
    for (int& channel : s.channel_of) channel = -1;
    for (int c = 0; c < Test::channel_count; ++c) s.channel_of[Test::channel(c).unknown(D)] = c;
    ++collect_.sources;
    return s;
  }

  /// Puts a term with so many tiles and bytes into the next launch of its kernel; returns where the term is to be
  /// written.
  std::byte* add_tiles(TileLaunch<Real>* kernel, int code, int tiles, std::size_t bytes) {
    TileSchedule& s = schedule_;
    if (kernel != kernel_ || s.count == most_sources || used_ + bytes > sizeof terms_) launch();
    kernel_ = kernel;
    s.code[s.count] = code;
    s.place[s.count] = static_cast<int>(used_);
    s.first[s.count + 1] = s.first[s.count] + tiles;
    constexpr std::size_t step = alignof(std::max_align_t);
    used_ += (bytes + step - 1) / step * step;
    return terms_ + s.place[s.count++];
  }
  const Real* direction() const { return direction_.data(); }

  /// Adds what the tiles have to a vector of unknowns.
  void add_to(const ArrayOf<Real>& out) {
    collect_.add = true;
    if (collect_.sources > 0) collect(out, {});
  }
  /// Gives the sums to a kernel of the caller, which is launched before other tiles.
  CollectTiles<D, Real> taken() {
    launch();
    CollectTiles<D, Real> sums = collect_;
    collect_.sources = 0;
    return sums;
  }
  /// out = what the tiles have, times a mask where there is one.
  void store(const ArrayOf<Real>& out, const ConstArray& mask) {
    collect_.add = false;
    collect(out, mask);
  }

 private:
  void launch() {
    if (schedule_.count > 0) kernel_(schedule_, stored_bytes(terms_, used_), direction());
    schedule_ = {};
    std::memset(terms_, 0, used_);
    used_ = 0;
  }
  void collect(const ArrayOf<Real>& out, const ConstArray& mask) {
    launch();
    collect_.out = out;
    collect_.mask = mask;
    Kokkos::parallel_for("softwet::collect", Items(0, static_cast<int>(out.extent(0))), collect_);
    collect_.sources = 0;
  }

  ConstArrayOf<Real> direction_;
  TileLaunch<Real>* kernel_ = nullptr;
  TileSchedule schedule_;
  alignas(std::max_align_t) std::byte terms_[most_stored_bytes] = {};
  std::size_t used_ = 0;  ///< of these bytes
  CollectTiles<D, Real> collect_;
};

}  // namespace softwet
