#include "solver/schwarz/boxes.hpp"

#include <algorithm>
#include <cmath>

#include "memory/large_pages.hpp"
#include "solver/schwarz/box_rows.hpp"

namespace softwet {

namespace {

using Indices = Kokkos::View<const int*, Exec>;
/// Boxes whose matrices are held at once during a build: enough to keep all threads busy, and few for the caches.
int batch_size() { return chunk(std::max(32, 4 * Kokkos::DefaultHostExecutionSpace().concurrency()), 4096); }

template <class View, class Number>
void copy_in(const View& to, const Number* from, int count) {
  const Kokkos::View<const Number*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(from, count);
  Kokkos::deep_copy(Kokkos::subview(to, Kokkos::make_pair(0, count)), host);
}

/// Inverses of blocks into their strips. An item is a piece of a column.
struct Store {
  Indices size, box;  ///< size 0: the box uses another one's inverse
  DenseBlocks blocks;
  BoxInverses inverses;
  int unknowns;

  KOKKOS_FUNCTION int pieces() const { return chunks_in(unknowns, rows_at_once); }
  std::int64_t items(int count) const { return std::int64_t(count) * unknowns * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int row = static_cast<int>(item % pieces()) * rows_at_once,
              column = static_cast<int>(item / pieces() % unknowns);
    const int block = static_cast<int>(item / pieces() / unknowns), n = size(block);
    if (column >= n || row >= n) return;
    std::uint16_t* to = inverses.place(box(block), n, row, column);
    for (int i = 0; i < rows_at_once; ++i)
      to[i] = row + i < n ? narrow(entry_of_inverse(blocks, block, row + i, column)) : 0;
  }
};

}  // namespace

template <int D>
Boxes<D>::Boxes(const Layout<D>& layout, const ConstArray& mask, int width, int stride, float share)
    : Boxes(layout, make_patches(layout, UnknownTable<D>(layout, to_host(mask)), width, stride), width, share) {}

template <int D>
Boxes<D>::Boxes(const Layout<D>& layout, const PatchTables& t, int width, float share)
    : width_(width),
      count_(t.count),
      unknowns_(t.unknowns),
      sites_(t.sites),
      row_(t.row),
      round_(layout.axis[0].periodic() ? layout.axis[0].owned() : 0),
      sizes_(t.size),
      shared_(t, layout.components(), share) {
  if (!host_algorithms) inverses_.strip = chunks_in(unknowns_, rows_at_once) * rows_at_once;
  for (int n : t.size) most_ += inverses_.room(n);
  used_ = most_;
  begin_.resize(count_);
  const auto to_view = [](const std::vector<int>& v) { return to_device<Table>(v); };
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

/// Whole rows of boxes, as many as make a batch, or as a wave has.
template <int D>
int Boxes<D>::batch() const {
  return std::min(shared_.largest_wave(), (batch_size() + row_ - 1) / row_ * row_);
}

template <int D>
void Boxes<D>::allocate() {
  const auto fresh = [](const std::string& label) { return Kokkos::view_alloc(label, Kokkos::WithoutInitializing); };
  inverses_.entry = large_array<Kokkos::View<std::uint16_t*, Exec>>("boxes.inverse", most_);
  inverses_.begin = Kokkos::View<std::int64_t*, Exec>("boxes.begin", count_);
  member_ = Table("boxes.member", count_);
  first_member_ = Table("boxes.first_member", count_ + 1);
  out_ = Kokkos::View<float*, Exec>(fresh("boxes.out"), std::size_t(count_) * unknowns_);
  blocks_ = DenseBlocks(fresh("boxes.blocks"), batch(), unknowns_, unknowns_);
  block_box_ = Table("boxes.block_box", batch());
  to_invert_ = Table("boxes.to_invert", batch());
  invert_.emplace(batch(), unknowns_);
}

template <int D>
void Boxes<D>::build(const StencilMatrix<D>& matrix) {
  if (inverses_.entry.extent(0) == 0) allocate();
  used_ = built_ = 0;
  for (const std::vector<int>& wave : shared_.waves())
    for (int first = 0; first < static_cast<int>(wave.size()); first += batch())
      build_some(matrix, wave.data() + first, std::min(batch(), static_cast<int>(wave.size()) - first));
  group();
}

/// Builds boxes of one wave, as many as a batch has room for.
template <int D>
void Boxes<D>::build_some(const StencilMatrix<D>& matrix, const int* boxes, int count) {
  const auto some = Kokkos::make_pair(0, count);
  const DenseBlocks blocks = Kokkos::subview(blocks_, some, Kokkos::ALL, Kokkos::ALL);
  const auto size = Kokkos::subview(to_invert_, some), box = Kokkos::subview(block_box_, some);
  copy_in(box, boxes, count);
  const BoxRows<D> rows{matrix.stencil(), matrix.values(), size_,  local_, start_, column_, box,
                        blocks,           sites_,          width_, round_};
  if constexpr (host_algorithms) {
    const FillRows<D> fill{rows, row_};
    Kokkos::parallel_for("softwet::boxes", Items(0, fill.items(count)), fill);
  } else {
    FillRowsByTeams<D>{rows}.run(count);
  }
  shared_.choose(boxes, count, blocks, inverses_);
  place_inverses(boxes, count);
  invert_->invert(blocks, size);
  const Store store{size, box, blocks, inverses_, unknowns_};
  Kokkos::parallel_for("softwet::store", LongItems(0, store.items(count)), store);
}

/// Gives room to the inverses of a batch, one after another.
template <int D>
void Boxes<D>::place_inverses(const int* boxes, int count) {
  std::vector<int> size(count, 0);
  for (int b = 0; b < count; ++b) {
    const int box = boxes[b], owner = shared_.owner(box);
    begin_[box] = owner == box ? used_ : begin_[owner];
    if (owner != box) continue;
    size[b] = sizes_[box];
    used_ += inverses_.room(size[b]);
    ++built_;
  }
  copy_in(to_invert_, size.data(), count);
  copy_in(inverses_.begin, begin_.data(), count_);
}

/// Cuts the boxes into items that are multiplied together.
template <int D>
void Boxes<D>::group() {
  const std::vector<int> boxes = shared_.by_owner();
  std::vector<int> first;
  for (int i = 0, begin = 0; i < count_; ++i) {
    const bool together =
        i > begin && i < begin + most_together && shared_.owner(boxes[i]) == shared_.owner(boxes[begin]);
    if (together) continue;
    begin = i;
    first.push_back(i);
  }
  items_ = static_cast<int>(first.size());
  first.push_back(count_);
  copy_in(member_, boxes.data(), count_);
  copy_in(first_member_, first.data(), items_ + 1);
}

template <int D>
double Boxes<D>::bytes() const {
  return 2.0 * used_ + 4.0 * unknowns_ * (count_ + double(batch()) * unknowns_) +
         BatchInverse::bytes(batch(), unknowns_);
}

template class Boxes<2>;
template class Boxes<3>;

}  // namespace softwet
