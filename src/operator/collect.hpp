// What tiles have summed, as control values: in one launch for all terms of an evaluation.
#pragma once

#include "field/layout.hpp"
#include "operator/tile_shape.hpp"

namespace softwet {

inline constexpr int most_sources = 12;

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
  int sources;
  int extent[D - 1], row_size;
  int components, offset[D + 2], first_row[D + 2];
  ArrayOf<Real> out;
  ConstArray mask;  ///< empty: none
  bool add;         ///< to what is in `out`

  KOKKOS_FUNCTION void operator()(int entry) const {
    int c = components - 1;
    while (entry < offset[c]) --c;
    int rest = entry - offset[c], at[D];
    at[D - 1] = rest / row_size + first_row[c];
    rest %= row_size;
    at[0] = rest % extent[0];
    if constexpr (D == 3) at[1] = rest / extent[0];
    Real total = add ? out(entry) : Real(0);
    for (int s = 0; s < sources; ++s)
      if (source[s].channel_of[c] >= 0) total += source[s].sum(at, source[s].channel_of[c]);
    out(entry) = mask.data() ? static_cast<Real>(mask(entry)) * total : total;
  }
};

/// Room for the partial sums of one term; grown when needed, released before Kokkos ends.
template <class Real>
Real* tile_room(int term, std::size_t size) {
  static std::vector<ArrayOf<Real>> rooms;
  if (rooms.empty()) {
    rooms.resize(most_sources);
    Kokkos::push_finalize_hook([] { rooms.clear(); });
  }
  if (rooms[term].extent(0) < size)
    rooms[term] = ArrayOf<Real>(Kokkos::view_alloc("tiles", Kokkos::WithoutInitializing), size);
  return rooms[term].data();
}

/// The terms of one evaluation that were computed in tiles. On the host there are none.
template <int D, class Real>
class TileSums {
 public:
  explicit TileSums(const Layout<D>& layout) {
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

  /// Adds what the tiles have to a vector of unknowns.
  void add_to(const ArrayOf<Real>& out) {
    if (collect_.sources > 0) collect(out, {}, true);
  }
  /// out = what the tiles have, times a mask where there is one.
  void store(const ArrayOf<Real>& out, const ConstArray& mask) { collect(out, mask, false); }

 private:
  void collect(const ArrayOf<Real>& out, const ConstArray& mask, bool add) {
    collect_.out = out;
    collect_.mask = mask;
    collect_.add = add;
    Kokkos::parallel_for("softwet::collect", Kokkos::RangePolicy<Exec>(0, static_cast<int>(out.extent(0))), collect_);
    collect_.sources = 0;
  }

  CollectTiles<D, Real> collect_;
};

}  // namespace softwet
