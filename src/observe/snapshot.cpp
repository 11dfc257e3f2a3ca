#include "observe/snapshot.hpp"

#include <stdexcept>
#include <utility>

#include "field/exchange.hpp"
#include "field/vector.hpp"
#include "kernels/point/geometry.hpp"

namespace softwet {

template <int D>
void SnapshotCopies<D>::Copy::start(const ConstArray& array) {
  array_ = array;
  if constexpr (on_host) return;
  const std::size_t size = array.extent(0);
  if (room_.extent(0) < size) room_ = HostArray(Kokkos::view_alloc("snapshot", Kokkos::WithoutInitializing), size);
  if (size > 0) Kokkos::deep_copy(Exec(), Kokkos::subview(room_, Kokkos::make_pair(std::size_t(0), size)), array);
}

template <int D>
std::vector<double> SnapshotCopies<D>::Copy::take() {
  const ConstArray array = std::exchange(array_, {});
  const double* values = on_host ? array.data() : room_.data();
  return std::vector<double>(values, values + array.extent(0));
}

template <int D>
void SnapshotCopies<D>::start(const Layout<D>& layout, const State& state, SnapshotOf parts) {
  scalars_.start(part(state.unknown, layout.density_offset(), layout.size()));
  displacement_.start(state.displacement);
  const bool rates = parts == SnapshotOf::all_fields;
  velocity_.start(rates ? part(state.unknown, 0, layout.velocity_size()) : ConstArray());
  memory_.start(rates ? ConstArray(state.memory) : ConstArray());
}

template <int D>
Snapshot<D>::Snapshot(const Layout<D>& layout, SnapshotCopies<D>& copies)
    : layout_(layout.whole_patch()),
      velocity_(collect_on_root(layout, copies.velocity_.take())),
      scalars_(collect_on_root(layout, copies.scalars_.take())),
      displacement_(collect_on_root(layout, copies.displacement_.take())),
      memory_(collect_on_root(layout, copies.memory_.take())) {}

template <int D>
Snapshot<D>::Snapshot(const Layout<D>& layout, const State& state, SnapshotOf parts)
    : layout_(layout.whole_patch()),
      scalars_(to_host_on_root(layout, part(state.unknown, layout.density_offset(), layout.size()))),
      displacement_(to_host_on_root(layout, state.displacement)) {
  if (parts != SnapshotOf::all_fields) return;
  velocity_ = to_host_on_root(layout, part(state.unknown, 0, layout.velocity_size()));
  memory_ = to_host_on_root(layout, state.memory);
}

template <int D>
std::vector<double> Snapshot<D>::component(const std::vector<double>& values, int first, int rows, const Grid& grid,
                                           int shift, int lowest, int highest, int derivative) const {
  if (values.empty()) throw std::logic_error("this snapshot does not hold the field that is asked for");
  std::array<int, D> extent;
  std::array<AxisSamples, D> at;
  for (int d = 0; d < D; ++d) {
    const bool last = d == D - 1;
    extent[d] = last ? rows : layout_.axis[d].functions();
    const Sampled sampled = d == derivative ? Sampled::slopes : Sampled::values;
    at[d] = last ? sample_axis(layout_.axis[d], grid[d], sampled, shift, lowest, highest)
                 : sample_axis(layout_.axis[d], grid[d], sampled);
  }
  return evaluate_grid<D>(values.data() + first, extent, at);
}

template <int D>
std::vector<double> Snapshot<D>::velocity(const Grid& grid, int d, Medium in) const {
  const bool in_fluid = in == Medium::fluid;
  const int all = layout_.axis[D - 1].elements();
  return component(velocity_, layout_.velocity_offset(d), layout_.rows, grid, 0, in_fluid ? layout_.solid_elements : 0,
                   in_fluid ? all : layout_.solid_elements);
}

template <int D>
std::vector<double> Snapshot<D>::density(const Grid& grid, int derivative) const {
  return component(scalars_, 0, layout_.fluid_rows(), grid, layout_.wall_row, layout_.solid_elements,
                   layout_.axis[D - 1].elements(), derivative);
}

template <int D>
std::vector<double> Snapshot<D>::chemical_potential(const Grid& grid) const {
  return component(scalars_, layout_.scalar_size(), layout_.fluid_rows(), grid, layout_.wall_row,
                   layout_.solid_elements, layout_.axis[D - 1].elements());
}

template <int D>
std::vector<double> Snapshot<D>::displacement(const Grid& grid, int d, Medium in) const {
  if (!layout_.has_solid) {
    std::size_t points = 1;
    for (const std::vector<double>& places : grid) points *= places.size();
    return std::vector<double>(points, 0.0);
  }
  const int first = layout_.displacement_offset(d);
  if (in == Medium::solid)
    return component(displacement_, first, layout_.solid_rows(), grid, 0, 0, layout_.solid_elements);
  Grid wall = grid;
  wall[D - 1] = {wall_height()};
  const std::vector<double> trace =
      component(displacement_, first, layout_.solid_rows(), wall, 0, 0, layout_.solid_elements);
  const Blend blend{wall_height(), layout_.axis[D - 1].length() - wall_height()};
  std::vector<double> result;
  for (double y : grid[D - 1])
    for (double u : trace) result.push_back(blend.value(y) * u);
  return result;
}

template <int D>
std::vector<double> Snapshot<D>::displacement_gradient(const Grid& grid, int d, int axis, ElementRows rows) const {
  return component(displacement_, layout_.displacement_offset(d), layout_.solid_rows(), grid, 0, rows.first, rows.last,
                   axis);
}

template <int D>
std::vector<double> Snapshot<D>::velocity_gradient(const Grid& grid, int d, int axis, ElementRows rows) const {
  return component(velocity_, layout_.velocity_offset(d), layout_.rows, grid, 0, rows.first, rows.last, axis);
}

template <int D>
std::vector<double> Snapshot<D>::branch_gradient(const Grid& grid, int branch, int d, int axis,
                                                 ElementRows rows) const {
  return component(memory_, branch * layout_.branch_size() + layout_.displacement_offset(d), layout_.solid_rows(), grid,
                   0, rows.first, rows.last, axis);
}

template <int D>
std::vector<double> Snapshot<D>::branch_displacement(const Grid& grid, int branch, int d) const {
  return component(memory_, branch * layout_.branch_size() + layout_.displacement_offset(d), layout_.solid_rows(), grid,
                   0, 0, layout_.solid_elements);
}

template <int D>
std::vector<double> Snapshot<D>::displacement(const std::array<AxisSamples, D>& at, int d) const {
  std::array<int, D> extent;
  for (int axis = 0; axis < D; ++axis)
    extent[axis] = axis == D - 1 ? layout_.solid_rows() : layout_.axis[axis].functions();
  return evaluate_grid<D>(displacement_.data() + layout_.displacement_offset(d), extent, at);
}

template <int D>
std::vector<ElementRows> Snapshot<D>::solid_parts() const {
  const int joint = layout_.axis[D - 1].joint();
  if (joint == 0) return {solid_rows()};
  return {{0, joint}, {joint, layout_.solid_elements}};
}

template class SnapshotCopies<2>;
template class SnapshotCopies<3>;
template class Snapshot<2>;
template class Snapshot<3>;

}  // namespace softwet
