#include "time/masses/end_ties.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softwet {
namespace {

/// Number of the cluster of each value: those that ties connect have the same one. -1: it has no tie.
template <class Set>
std::vector<int> clusters_of(const std::vector<Set>& sets) {
  int size = 0;
  for (const Set& set : sets)
    for (const auto& tie : set) size = std::max({size, tie.first + 1, tie.first + tie.step + 1});
  std::vector<int> root(size, -1);
  const auto root_of = [&](int i) {
    if (root[i] < 0) root[i] = i;
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Set& set : sets)
    for (const auto& tie : set) root[root_of(tie.first)] = root_of(tie.first + tie.step);
  for (int i = 0; i < size; ++i)
    if (root[i] >= 0) root[i] = root_of(i);
  return root;
}

/// The ties of sets, one after another, as runs by block.
std::vector<TieRun> runs_of(const std::vector<std::vector<EndTie>>& sequence, const std::vector<int>& block) {
  std::vector<TieRun> runs;
  for (std::vector<EndTie> set : sequence) {
    std::stable_sort(set.begin(), set.end(), [&](const EndTie& a, const EndTie& b) {
      return std::pair(block[a.first], a.step) < std::pair(block[b.first], b.step);
    });
    const std::size_t first_of_set = runs.size();
    for (const EndTie& tie : set) {
      TieRun* last = runs.size() > first_of_set ? &runs.back() : nullptr;
      const int distance = last ? tie.first - last->tie.first : 0;
      const bool follows = last && last->tie.step == tie.step && block[last->tie.first] == block[tie.first] &&
                           tie.node - last->tie.node == distance;
      if (follows && last->count == 1) last->apart = distance;
      if (follows && distance == last->count * last->apart) {
        ++last->count;
      } else {
        runs.push_back({tie, 1, 1});
      }
    }
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [&](const TieRun& a, const TieRun& b) { return block[a.tie.first] < block[b.tie.first]; });
  return runs;
}

/// The clusters of ties that are sorted by block and cluster, and their values.
struct InBlocks {
  int nodes, values, blocks;
  double kept;
};
TieClusters in_order(const std::vector<EndTie>& sequence, const std::vector<int>& cluster,
                     const std::vector<int>& block, const InBlocks& layout) {
  std::vector<int> start{0}, member, first_member{0}, of_block(layout.blocks + 1, 0);
  std::vector<char> tied(layout.values, 0);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    for (const int value : {sequence[i].first, sequence[i].first + sequence[i].step})
      if (!std::exchange(tied[value], 1)) member.push_back(value);
    if (i + 1 < sequence.size() && cluster[sequence[i + 1].first] == cluster[sequence[i].first]) continue;
    start.push_back(static_cast<int>(i + 1));
    first_member.push_back(static_cast<int>(member.size()));
    ++of_block[block[sequence[i].first] + 1];
  }
  for (int b = 0; b < layout.blocks; ++b) of_block[b + 1] += of_block[b];
  using Numbers = Kokkos::View<int*, Exec>;
  return {to_device<Kokkos::View<EndTie*, Exec>>(sequence, "ties"),
          to_device<Numbers>(start, "ties"),
          to_device<Numbers>(member, "ties"),
          to_device<Numbers>(first_member, "ties"),
          to_device<Kokkos::View<char*, Exec>>(tied, "ties"),
          to_device<Numbers>(of_block, "ties"),
          {},
          {},
          layout.nodes,
          1 - std::sqrt(layout.kept),
          1 - layout.kept};
}

/// Undoes the ties of a cluster: `ties` keep what those have left.
struct Untie {
  TieClusters ties;
  Array x;
  ConstArray weights;
  KOKKOS_FUNCTION void operator()(int cluster) const {
    ties.smooth(cluster, {x.data(), weights.data(), nullptr, nullptr});
  }
};

}  // namespace

template <int D>
EndTies<D>::EndTies(const Layout<D>& l, const ConstArray& device_mask) {
  const std::vector<double> mask = to_host(device_mask);
  std::vector<Set> velocity, scalar;
  const auto add = [&](std::vector<Set>& sets, int first, int last, int axis, int extent) {
    constexpr int apart = 4;  // functions that two ends need
    if (l.axis[axis].periodic()) return;
    if (extent >= apart) return sets.push_back(make_set(l, mask, first, last, axis, {End::low, End::high}));
    for (const End end : {End::low, End::high}) sets.push_back(make_set(l, mask, first, last, axis, {end}));
  };
  for (int axis = 0; axis < D; ++axis) {
    const int extent = l.axis[axis].functions();
    add(velocity, 0, D, axis, extent);
    if (l.has_fluid) add(scalar, D, D + 1, axis, axis == D - 1 ? l.fluid_rows() : extent);
  }
  if (l.has_fluid && l.has_solid) velocity.push_back(make_set(l, mask, 0, D, D - 1, {End::below_wall}));
  if (l.axis[D - 1].joint() > 0) velocity.push_back(make_set(l, mask, 0, D, D - 1, {End::below_joint}));
  velocity_ = clusters(velocity, LineBlocks<D>(l, Unknowns::velocities), D, kept_of_velocities);
  scalar_ = clusters(scalar, LineBlocks<D>(l, Unknowns::scalars), 1, kept_of_scalars);
}

template <int D>
typename EndTies<D>::Set EndTies<D>::make_set(const Layout<D>& l, const std::vector<double>& mask, int first_component,
                                              int last_component, int axis, const std::vector<End>& ends) const {
  Set set;
  const std::vector<Box<D>> all = boxes(l);
  const auto place_of = [&](End end, int last) {
    switch (end) {
      case End::low:
        return 0;
      case End::high:
        return last;
      case End::below_wall:
        return l.wall_row;
      default:
        return l.axis[D - 1].span(l.axis[D - 1].joint());
    }
  };
  for (int c = first_component; c < last_component; ++c) {
    const Box<D>& box = all[c];
    int stride = 1, size = 1;
    for (int d = 0; d < D; ++d) size *= box.extent[d];
    for (int d = 0; d < axis; ++d) stride *= box.extent[d];
    const int extent = box.extent[axis], last = (axis == D - 1 ? extent : l.axis[axis].functions()) - 1;
    for (int i = 0; i < size; ++i) {
      const int place = i / stride % extent, function = axis == D - 1 ? place : l.function(place, axis);
      for (const End end : ends) {
        const int at_end = place_of(end, last);
        const int way = end == End::low ? stride : -stride, at = box.offset + i;
        if (function != at_end || mask[at] == 0 || mask[at + way] == 0) continue;
        set.push_back({at - all[first_component].offset, way, i, false});
      }
    }
  }
  return set;
}

template <int D>
TieClusters EndTies<D>::clusters(const std::vector<Set>& all, const LineBlocks<D>& blocks, int components,
                                 double kept) {
  std::vector<Set> sets;
  for (const Set& set : all)
    if (!set.empty()) sets.push_back(set);
  std::vector<Set> in_turn = sets;
  if (!sets.empty()) {
    for (EndTie& tie : in_turn.back()) tie.whole = true;
    in_turn.insert(in_turn.end(), sets.rbegin() + 1, sets.rend());
  }
  std::vector<EndTie> sequence;
  for (const Set& set : in_turn) sequence.insert(sequence.end(), set.begin(), set.end());
  const std::vector<int> cluster = clusters_of(sets);
  std::vector<int> block(cluster.size(), 0);
  for (std::size_t i = 0; host_algorithms && i < cluster.size(); ++i)  // a device has no blocks
    if (cluster[i] >= 0) block[i] = blocks.of(cluster[i]);
  std::stable_sort(sequence.begin(), sequence.end(), [&](const EndTie& a, const EndTie& b) {
    return std::pair(block[a.first], cluster[a.first]) < std::pair(block[b.first], cluster[b.first]);
  });
  const int all_blocks = components * blocks.count();
  TieClusters found = in_order(sequence, cluster, block, {blocks.nodes, components * blocks.nodes, all_blocks, kept});
  if (!host_algorithms) return found;
  const std::vector<TieRun> runs = runs_of(in_turn, block);
  std::vector<int> first_run(all_blocks + 1, 0);
  for (const TieRun& run : runs) ++first_run[block[run.tie.first] + 1];
  for (int b = 0; b < all_blocks; ++b) first_run[b + 1] += first_run[b];
  found.runs = to_device<Kokkos::View<TieRun*, Exec>>(runs, "ties");
  found.first_run = to_device<Kokkos::View<int*, Exec>>(first_run, "ties");
  return found;
}

template <int D>
void EndTies<D>::untie_scalars(const Array& x, const ConstArray& weights) const {
  TieClusters back = scalar_;
  back.half = 1 - std::sqrt(1 / kept_of_scalars);
  back.whole = 1 - 1 / kept_of_scalars;
  if (back.count() > 0) Kokkos::parallel_for("softwet::ties", Items(0, back.count()), Untie{back, x, weights});
}

template class EndTies<2>;
template class EndTies<3>;

}  // namespace softwet
