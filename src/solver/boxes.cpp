#include "solver/boxes.hpp"

#include <cmath>

#include "solver/dense_inverse.hpp"
#include "solver/patches.hpp"

namespace softwet {

namespace {

using Indices = Kokkos::View<const int*, Exec>;
using Inverses = Kokkos::View<std::uint16_t*, Exec>;

constexpr int rows_at_once = on_host ? 64 : 1;
constexpr int batch_size = on_host ? 256 : 4096;  ///< boxes whose matrices are held at once during a build

/// The upper half of a float, rounded to nearest, and back. What is not finite stays so.
KOKKOS_INLINE_FUNCTION std::uint16_t narrow(float x) {
  const auto bits = Kokkos::bit_cast<std::uint32_t>(x);
  if ((bits & 0x7f800000u) == 0x7f800000u) return 0x7fc0u;
  return static_cast<std::uint16_t>((bits + 0x7fffu + ((bits >> 16) & 1u)) >> 16);
}
KOKKOS_INLINE_FUNCTION float widen(std::uint16_t x) { return Kokkos::bit_cast<float>(std::uint32_t(x) << 16); }

/// One row of the matrix of box `first` + block out of the stencil.
template <int D>
struct FillRow {
  Stencil<D> stencil;
  StencilValues values;
  Indices size, site, local, start;
  DenseBlocks blocks;
  int first, unknowns, sites, width;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int block = item / unknowns, row = item % unknowns, box = first + block;
    if (row >= size(box)) return;
    for (int j = 0; j < unknowns; ++j) blocks(block, row, j) = 0;
    const int place = site(box * unknowns + row), a = place % stencil.components;
    int point = 0, stride = 1, at[D];
    for (int d = 0, rest = place / stencil.components; d < D; ++d) {
      at[d] = rest % width;
      rest /= width;
      point += stride * stencil.moved(start(box * D + d), at[d], d);
      stride *= stencil.extent[d];
    }
    for (int o = 0; o < stencil.offsets; ++o) {
      int to = 0, step = 1;  // control point of the column in the box
      for (int d = 0; d < D; ++d) {
        // A box that goes all around a periodic axis closes on itself.
        const int i = wrapped(at[d] + stencil.shift(o, d), width, stencil.period[d]);
        to = i < 0 ? -1 : to < 0 ? -1 : to + step * i;
        step *= width;
      }
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u) {
        const int column = local(box * sites + to * stencil.components + u);
        if (column >= 0) blocks(block, row, column) += values(stencil.index(a, u, o, point));
      }
    }
  }
};

/// Inverses of blocks [block][column][row] into their strips.
struct Store {
  Indices size;
  DenseBlocks blocks;
  Inverses inverse;
  int first, unknowns, strip, strips;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int block = item / unknowns, column = item % unknowns, box = first + block;
    const int n = size(box);
    if (column >= n) return;
    for (int row = 0; row < strips * strip; ++row) {
      const std::int64_t line = (std::int64_t(box) * strips + row / strip) * unknowns + column;
      inverse(line * strip + row % strip) = row < n ? narrow(blocks(block, column, row)) : 0;
    }
  }
};

/// out = W_b A_b^-1 W_b r on every box. Lanes (host) or threads (device) take neighbouring rows and walk along the
/// columns together.
struct ApplyBoxes {
  Indices size, dof;
  Inverses inverse;
  Kokkos::View<const float*, Exec> weight;
  ConstArray r;
  Kokkos::View<float**, Kokkos::LayoutRight, Exec> out;
  int unknowns, strip, strips;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int box = team.league_rank(), n = size(box);
    const Scratch local(team.team_scratch(0), unknowns);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      const int unknown = dof(box * unknowns + i);
      local(i) = static_cast<float>(r(unknown)) * weight(unknown);
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, (n + rows_at_once - 1) / rows_at_once), [&](int chunk) {
      const int first = chunk * rows_at_once;
      const std::int64_t line = (std::int64_t(box) * strips + first / strip) * unknowns;
      const std::uint16_t* column = inverse.data() + line * strip + first % strip;
      float sum[rows_at_once] = {};
      for (int j = 0; j < n; ++j, column += strip)
        for (int i = 0; i < rows_at_once; ++i) sum[i] += widen(column[i]) * local(j);
      for (int i = 0; i < rows_at_once && first + i < n; ++i) out(box, first + i) = sum[i];
    });
  }
};

/// z += factor times what the boxes say of each unknown.
struct Collect {
  Indices grouped, place;
  Kokkos::View<const float*, Exec> weight;
  Kokkos::View<const float**, Kokkos::LayoutRight, Exec> out;
  Array z;
  int unknowns;
  float factor;
  KOKKOS_FUNCTION void operator()(int i) const {
    float sum = 0;
    for (int k = grouped(i); k < grouped(i + 1); ++k) sum += out(place(k) / unknowns, place(k) % unknowns);
    z(i) += factor * weight(i) * sum;
  }
};

}  // namespace

template <int D>
Boxes<D>::Boxes(const Layout<D>& layout, const ConstArray& mask, int width, int stride) : width_(width) {
  const PatchTables t = make_patches(layout, UnknownTable<D>(layout, to_host(mask)), width, stride);
  count_ = t.count;
  unknowns_ = t.unknowns;
  sites_ = t.sites;
  strip_ = on_host ? rows_at_once : unknowns_;
  strips_ = (unknowns_ + strip_ - 1) / strip_;
  const auto to_view = [](const std::vector<int>& v) { return to_device<Kokkos::View<int*, Exec>>(v); };
  size_ = to_view(t.size);
  dof_ = to_view(t.dof);
  site_ = to_view(t.site);
  local_ = to_view(t.local);
  start_ = to_view(t.start);
  place_ = to_view(t.place);
  grouped_ = to_view(t.grouped);
  std::vector<float> weight(layout.size());
  for (int i = 0; i < layout.size(); ++i)
    weight[i] = t.grouped[i + 1] > t.grouped[i] ? 1 / std::sqrt(float(t.grouped[i + 1] - t.grouped[i])) : 0;
  weight_ = to_device<Kokkos::View<float*, Exec>>(weight);
}

template <int D>
void Boxes<D>::build(const StencilMatrix<D>& matrix) {
  const auto fresh = [](const std::string& label) { return Kokkos::view_alloc(label, Kokkos::WithoutInitializing); };
  if (inverse_.extent(0) == 0) {
    inverse_ = Inverses(fresh("boxes.inverse"), std::int64_t(count_) * strips_ * strip_ * unknowns_);
    out_ = Kokkos::View<float**, Kokkos::LayoutRight, Exec>(fresh("boxes.out"), count_, unknowns_);
  }
  const int batch = std::min(count_, batch_size);
  const DenseBlocks blocks(fresh("boxes.blocks"), batch, unknowns_, unknowns_);
  for (int first = 0; first < count_; first += batch) {
    const int now = std::min(batch, count_ - first);
    const auto some = Kokkos::make_pair(first, first + now);
    const DenseBlocks part = Kokkos::subview(blocks, Kokkos::make_pair(0, now), Kokkos::ALL, Kokkos::ALL);
    const Kokkos::RangePolicy<Exec> lines(0, now * unknowns_);
    Kokkos::parallel_for("softwet::boxes", lines,
                         FillRow<D>{matrix.stencil(), matrix.values(), size_, site_, local_, start_, part, first,
                                    unknowns_, sites_, width_});
    invert(part, Kokkos::subview(size_, some));
    Kokkos::parallel_for("softwet::store", lines, Store{size_, part, inverse_, first, unknowns_, strip_, strips_});
  }
}

template <int D>
void Boxes<D>::add(const ConstArray& r, const Array& z, float factor) const {
  const std::size_t scratch = ApplyBoxes::Scratch::shmem_size(unknowns_);
  Kokkos::parallel_for(
      "softwet::schwarz",
      Kokkos::TeamPolicy<Exec>(count_, on_host ? 1 : 8, on_host ? 1 : 32).set_scratch_size(0, Kokkos::PerTeam(scratch)),
      ApplyBoxes{size_, dof_, inverse_, weight_, r, out_, unknowns_, strip_, strips_});
  Kokkos::parallel_for("softwet::collect", Kokkos::RangePolicy<Exec>(0, z.extent(0)),
                       Collect{grouped_, place_, weight_, out_, z, unknowns_, factor});
}

template <int D>
double Boxes<D>::bytes() const {
  return double(count_) * unknowns_ * (2.0 * strips_ * strip_ + 4.0) +
         4.0 * std::min(count_, batch_size) * unknowns_ * unknowns_;
}

template class Boxes<2>;
template class Boxes<3>;

}  // namespace softwet
