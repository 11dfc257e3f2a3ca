#include "time/end_ties.hpp"

#include <algorithm>
#include <cmath>

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

/// Takes a part of the difference of each pair away and keeps its mean, weighted with `weights`.
struct TieCluster {
  Kokkos::View<const EndTie*, Exec> ties;
  Kokkos::View<const int*, Exec> start;
  int nodes;
  double half, whole;
  Array x;
  ConstArray weights;
  Array gains;

  KOKKOS_FUNCTION void operator()(int cluster) const {
    const bool gain = gains.data() != nullptr;
    for (int k = start(cluster); k < start(cluster + 1); ++k) {
      const int i = ties(k).first, j = i + ties(k).step;
      const double a = weights(i % nodes), b = weights(j % nodes);
      const double part = (ties(k).whole ? whole : half) * (x(i) - x(j)) / (a + b);
      x(i) -= b * part;
      x(j) += a * part;
      if (!gain) continue;
      gains(i) += b * part;
      gains(j) -= a * part;
    }
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
  velocity_ = make_group(velocity, l.rows * l.row_size);
  scalar_ = make_group(scalar, std::max(1, l.scalar_size()));
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
        set.push_back({at - all[first_component].offset, way, false});
      }
    }
  }
  return set;
}

template <int D>
typename EndTies<D>::Group EndTies<D>::make_group(const std::vector<Set>& all, int nodes) {
  std::vector<Set> sets;
  for (const Set& set : all)
    if (!set.empty()) sets.push_back(set);
  Group group;
  group.nodes = nodes;
  if (sets.empty()) return group;
  std::vector<EndTie> sequence;
  for (const Set& set : sets) sequence.insert(sequence.end(), set.begin(), set.end());
  for (std::size_t i = sequence.size() - sets.back().size(); i < sequence.size(); ++i) sequence[i].whole = true;
  for (auto set = sets.rbegin() + 1; set != sets.rend(); ++set)
    sequence.insert(sequence.end(), set->begin(), set->end());
  const std::vector<int> cluster = clusters_of(sets);
  std::stable_sort(sequence.begin(), sequence.end(),
                   [&](const EndTie& a, const EndTie& b) { return cluster[a.first] < cluster[b.first]; });
  std::vector<int> start = {0};
  for (std::size_t i = 1; i <= sequence.size(); ++i)
    if (i == sequence.size() || cluster[sequence[i].first] != cluster[sequence[i - 1].first])
      start.push_back(static_cast<int>(i));
  group.ties = to_device<Kokkos::View<EndTie*, Exec>>(sequence, "ties");
  group.start = to_device<Kokkos::View<int*, Exec>>(start, "ties");
  return group;
}

template <int D>
void EndTies<D>::smooth(const Group& group, double kept, const Array& x, const ConstArray& weights,
                        const Array& gains) const {
  if (group.ties.extent(0) == 0) return;
  const double half = 1 - std::sqrt(kept), whole = 1 - kept;  // twice the half makes a whole tie
  Kokkos::parallel_for("softwet::ties", Items(0, group.start.extent(0) - 1),
                       TieCluster{group.ties, group.start, group.nodes, half, whole, x, weights, gains});
}

template class EndTies<2>;
template class EndTies<3>;

}  // namespace softwet
