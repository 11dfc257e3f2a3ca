#include "time/end_ties.hpp"

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

using Indices = Kokkos::View<const int*, Exec>;

/// Takes a part of the difference of each pair away and keeps its mean, weighted with `weights`.
void tie_pairs(const Indices& first, const Indices& step, int nodes, double removed, const Array& x,
               const ConstArray& weights, const Array& gains) {
  const bool gain = gains.data() != nullptr;
  Kokkos::parallel_for(
      "softwet::ties", Items(0, first.extent(0)), KOKKOS_LAMBDA(int pair) {
        const int i = first(pair), j = i + step(pair);
        const double a = weights(i % nodes), b = weights(j % nodes);
        const double part = removed * (x(i) - x(j)) / (a + b);
        x(i) -= b * part;
        x(j) += a * part;
        if (gain) {
          gains(i) += b * part;
          gains(j) -= a * part;
        }
      });
}

}  // namespace

template <int D>
EndTies<D>::EndTies(const Layout<D>& l, const ConstArray& device_mask) {
  const std::vector<double> mask = to_host(device_mask);
  velocity_.nodes = l.rows * l.row_size;
  scalar_.nodes = std::max(1, l.scalar_size());
  const auto add = [&](Group& group, int first, int last, int axis, int extent) {
    constexpr int apart = 4;  // functions that two ends need
    if (l.axis[axis].periodic()) return;
    if (extent >= apart) return add_set(group, l, mask, first, last, axis, {End::low, End::high});
    for (const End end : {End::low, End::high}) add_set(group, l, mask, first, last, axis, {end});
  };
  for (int axis = 0; axis < D; ++axis) {
    const int extent = l.axis[axis].functions();
    add(velocity_, 0, D, axis, extent);
    if (l.has_fluid) add(scalar_, D, D + 1, axis, axis == D - 1 ? l.fluid_rows() : extent);
  }
  if (l.has_fluid && l.has_solid) add_set(velocity_, l, mask, 0, D, D - 1, {End::below_wall});
}

template <int D>
void EndTies<D>::add_set(Group& group, const Layout<D>& l, const std::vector<double>& mask, int first_component,
                         int last_component, int axis, const std::vector<End>& ends) {
  std::vector<int> first, step;
  const std::vector<Box<D>> all = boxes(l);
  for (int c = first_component; c < last_component; ++c) {
    const Box<D>& box = all[c];
    int stride = 1, size = 1;
    for (int d = 0; d < D; ++d) size *= box.extent[d];
    for (int d = 0; d < axis; ++d) stride *= box.extent[d];
    const int extent = box.extent[axis], last = (axis == D - 1 ? extent : l.axis[axis].functions()) - 1;
    for (int i = 0; i < size; ++i) {
      const int place = i / stride % extent, function = axis == D - 1 ? place : l.function(place, axis);
      for (const End end : ends) {
        const int at_end = end == End::low ? 0 : end == End::high ? last : l.wall_row;
        const int way = end == End::low ? stride : -stride, at = box.offset + i;
        if (function != at_end || mask[at] == 0 || mask[at + way] == 0) continue;
        first.push_back(at - all[first_component].offset);
        step.push_back(way);
      }
    }
  }
  using View = Kokkos::View<int*, Exec>;
  if (!first.empty()) group.sets.push_back({to_device<View>(first, "ties"), to_device<View>(step, "ties")});
}

template <int D>
void EndTies<D>::smooth(const Group& group, double kept, const Array& x, const ConstArray& weights,
                        const Array& gains) const {
  const double half = 1 - std::sqrt(kept);  // twice makes a whole tie
  const int last = static_cast<int>(group.sets.size()) - 1;
  const auto tie = [&](int set, double removed) {
    tie_pairs(group.sets[set].first, group.sets[set].step, group.nodes, removed, x, weights, gains);
  };
  for (int set = 0; set < last; ++set) tie(set, half);
  if (last >= 0) tie(last, 1 - kept);
  for (int set = last - 1; set >= 0; --set) tie(set, half);
}

template class EndTies<2>;
template class EndTies<3>;

}  // namespace softwet
