#include "solver/boxes.hpp"

#include <algorithm>
#include <cmath>

#include "solver/bfloat16.hpp"
#include "solver/large_pages.hpp"

namespace softwet {

namespace {

using Indices = Kokkos::View<const int*, Exec>;
using Inverses = Kokkos::View<std::uint16_t*, Exec>;
using EntryPlaces = Kokkos::View<const std::int64_t*, Exec>;

constexpr int rows_at_once = host_algorithms ? 64 : 1;
constexpr int prefetched = 24;  ///< columns ahead of the one that is read

/// Boxes whose matrices are held at once during a build: enough to keep all threads busy, and few for the caches.
int batch_size() {
  return host_algorithms ? std::max(32, 4 * Kokkos::DefaultHostExecutionSpace().concurrency()) : 4096;
}

KOKKOS_FORCEINLINE_FUNCTION void prefetch([[maybe_unused]] const void* p) {
  KOKKOS_IF_ON_HOST((__builtin_prefetch(p);))
}

/// Rows of the boxes' matrices out of the stencil: those of one component on one line of control points of a box. On the
/// host an item does so for all boxes that follow each other along the first axis, for their values lie side by side.
template <int D>
struct FillRows {
  Stencil<D> stencil;
  StencilValues values;
  Indices size, local, start, column_of;
  DenseBlocks blocks;
  int first, sites, width, together;
  int round;  ///< control points once around the first axis; 0: it is not periodic

  KOKKOS_FUNCTION int lines() const { return sites / stencil.components / width; }
  int items(int count) const { return count / together * lines() * stencil.components; }

  KOKKOS_FUNCTION void operator()(int item) const {
    const int a = item % stencil.components, line = item / stencil.components % lines();
    const int begin = item / stencil.components / lines() * together;
    int at[D], point = 0, stride = stencil.extent[0];
    for (int d = 1, rest = line; d < D; ++d) {
      at[d] = rest % width;
      rest /= width;
      point += stride * stencil.moved(start((first + begin) * D + d), at[d], d);
      stride *= stencil.extent[d];
    }
    for (int block = begin; block < begin + together; ++block) clear(block, line, a);
    const int shifts = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets; across += shifts) {
      const int to = neighbour_line(at, across);
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u)
        for (int o = 0; o < shifts; ++o) {
          const float* entry = values.data() + stencil.index(a, u, across + o, point);
          for (int block = begin; block < begin + together; ++block)
            add(block, line * width, a, to * width, u, o - stencil.degree, entry);
        }
    }
  }
  KOKKOS_FUNCTION int unknown(int block, int point, int component) const {
    return local((first + block) * sites + point * stencil.components + component);
  }
  KOKKOS_FUNCTION void clear(int block, int line, int a) const {
    const int n = size(first + block);
    for (int x = 0; x < width; ++x) {
      const int row = unknown(block, line * width + x, a);
      for (int j = 0; j < n && row >= 0; ++j) blocks(block, row, j) = 0;
    }
  }
  /// The line of a box at an offset from another; a box that goes all around a periodic axis closes on itself.
  KOKKOS_FUNCTION int neighbour_line(const int* at, int offset) const {
    int to = 0, step = 1;
    for (int d = 1; d < D; ++d) {
      const int i = wrapped(at[d] + stencil.shift(offset, d), width, stencil.period[d]);
      if (i < 0) return -1;
      to += step * i;
      step *= width;
    }
    return to;
  }
  KOKKOS_FUNCTION void add(int block, int line, int a, int to, int u, int shift, const float* entry) const {
    const int begin = start((first + block) * D);
    for (int x = 0; x < width; ++x) {
      const int there = wrapped(x + shift, width, round);
      const int row = unknown(block, line + x, a), column = there < 0 ? -1 : unknown(block, to + there, u);
      if (row >= 0 && column >= 0) blocks(block, row, column) += entry[column_of(begin + x)];
    }
  }
};

/// Inverses of blocks into their strips. An item is a piece of a column.
struct Store {
  Indices size;
  EntryPlaces begin;
  DenseBlocks blocks;
  Inverses inverse;
  int first, unknowns, strip;

  KOKKOS_FUNCTION int pieces() const { return (unknowns + rows_at_once - 1) / rows_at_once; }
  std::int64_t items(int count) const { return std::int64_t(count) * unknowns * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int row = static_cast<int>(item % pieces()) * rows_at_once,
              column = static_cast<int>(item / pieces() % unknowns);
    const int block = static_cast<int>(item / pieces() / unknowns), n = size(first + block);
    if (column >= n || row >= n) return;
    std::uint16_t* to = inverse.data() + begin(first + block) + (row / strip * n + column) * strip + row % strip;
    for (int i = 0; i < rows_at_once; ++i)
      to[i] = row + i < n ? narrow(entry_of_inverse(blocks, block, row + i, column)) : 0;
  }
};

/// out = W_b A_b^-1 W_b r on every box. Lanes (host) or threads (device) take neighbouring rows and walk along the
/// columns together.
struct ApplyBoxes {
  Indices size, dof;
  EntryPlaces begin;
  Inverses inverse;
  Kokkos::View<const float*, Exec> weight;
  ConstArray r;
  Kokkos::View<float*, Exec> out;
  int unknowns, strip;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int box = team.league_rank(), n = size(box);
    const Scratch local(team.team_scratch(0), unknowns);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
      const int unknown = dof(box * unknowns + i);
      local(i) = static_cast<float>(r(unknown)) * weight(unknown);
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, (n + rows_at_once - 1) / rows_at_once), [&](int chunk) {
      const int first = chunk * rows_at_once;
      const std::uint16_t* column = inverse.data() + begin(box) + (first / strip) * n * strip + first % strip;
      float sum[rows_at_once] = {};
      for (int j = 0; j < n; ++j, column += strip) {
        for (int i = 0; i < rows_at_once; i += 32) prefetch(column + prefetched * strip + i);
        for (int i = 0; i < rows_at_once; ++i) sum[i] += widen(column[i]) * local(j);
      }
      for (int i = 0; i < rows_at_once && first + i < n; ++i) out(box * unknowns + first + i) = sum[i];
    });
  }
};

/// z += factor times what the boxes say of each unknown.
struct Collect {
  Indices grouped, place;
  Kokkos::View<const float*, Exec> weight;
  Kokkos::View<const float*, Exec> out;
  Array z;
  float factor;
  KOKKOS_FUNCTION void operator()(int i) const {
    float sum = 0;
    for (int k = grouped(i); k < grouped(i + 1); ++k) sum += out(place(k));
    z(i) += factor * weight(i) * sum;
  }
};

}  // namespace

template <int D>
Boxes<D>::Boxes(const Layout<D>& layout, const ConstArray& mask, int width, int stride)
    : width_(width), round_(layout.axis[0].periodic() ? layout.axis[0].owned() : 0) {
  const PatchTables t = make_patches(layout, UnknownTable<D>(layout, to_host(mask)), width, stride);
  count_ = t.count;
  unknowns_ = t.unknowns;
  sites_ = t.sites;
  row_ = t.row;
  strip_ = host_algorithms ? rows_at_once : unknowns_;
  std::vector<std::int64_t> begin;
  for (int n : t.size) {
    begin.push_back(entries_);
    entries_ += std::int64_t((n + strip_ - 1) / strip_) * strip_ * n;
  }
  begin_ = to_device<Kokkos::View<std::int64_t*, Exec>>(begin);
  const auto to_view = [](const std::vector<int>& v) { return to_device<Kokkos::View<int*, Exec>>(v); };
  size_ = to_view(t.size);
  dof_ = to_view(t.dof);
  local_ = to_view(t.local);
  start_ = to_view(t.start);
  column_ = to_view(t.column);
  place_ = to_view(t.place);
  grouped_ = to_view(t.grouped);
  std::vector<float> weight(layout.size());
  for (int i = 0; i < layout.size(); ++i) weight[i] = t.holders[i] > 0 ? 1 / std::sqrt(float(t.holders[i])) : 0;
  weight_ = to_device<Kokkos::View<float*, Exec>>(weight);
}

/// Whole rows of boxes, as many as make a batch.
template <int D>
int Boxes<D>::batch() const {
  return std::min(count_, (batch_size() + row_ - 1) / row_ * row_);
}

template <int D>
void Boxes<D>::build(const StencilMatrix<D>& matrix) {
  const auto fresh = [](const std::string& label) { return Kokkos::view_alloc(label, Kokkos::WithoutInitializing); };
  if (inverse_.extent(0) == 0) {
    inverse_ = large_array<Inverses>("boxes.inverse", entries_);
    out_ = Kokkos::View<float*, Exec>(fresh("boxes.out"), std::size_t(count_) * unknowns_);
    blocks_ = DenseBlocks(fresh("boxes.blocks"), batch(), unknowns_, unknowns_);
    inverses_.emplace(batch(), unknowns_);
  }
  for (int first = 0; first < count_; first += batch()) {
    const int now = std::min(batch(), count_ - first);
    const auto some = Kokkos::make_pair(first, first + now);
    const DenseBlocks part = Kokkos::subview(blocks_, Kokkos::make_pair(0, now), Kokkos::ALL, Kokkos::ALL);
    const FillRows<D> fill{
        matrix.stencil(),           matrix.values(), size_, local_, start_, column_, part, first, sites_, width_,
        host_algorithms ? row_ : 1, round_};
    Kokkos::parallel_for("softwet::boxes", Kokkos::RangePolicy<Exec>(0, fill.items(now)), fill);
    inverses_->invert(part, Kokkos::subview(size_, some));
    const Store store{size_, begin_, part, inverse_, first, unknowns_, strip_};
    Kokkos::parallel_for("softwet::store",
                         Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>(0, store.items(now)), store);
  }
}

template <int D>
void Boxes<D>::add(const ConstArray& r, const Array& z, float factor) const {
  const std::size_t scratch = ApplyBoxes::Scratch::shmem_size(unknowns_);
  Kokkos::parallel_for(
      "softwet::schwarz",
      Kokkos::TeamPolicy<Exec>(count_, on_host ? 1 : 8, on_host ? 1 : 32).set_scratch_size(0, Kokkos::PerTeam(scratch)),
      ApplyBoxes{size_, dof_, begin_, inverse_, weight_, r, out_, unknowns_, strip_});
  Kokkos::parallel_for("softwet::collect", Kokkos::RangePolicy<Exec>(0, z.extent(0)),
                       Collect{grouped_, place_, weight_, out_, z, factor});
}

template <int D>
double Boxes<D>::bytes() const {
  return 2.0 * entries_ + 4.0 * unknowns_ * (count_ + double(batch()) * unknowns_) +
         BatchInverse::bytes(batch(), unknowns_);
}

template class Boxes<2>;
template class Boxes<3>;

}  // namespace softwet
