#include "observe/snapshot.hpp"

#include <algorithm>
#include <cmath>

#include "field/exchange.hpp"
#include "kernels/point/geometry.hpp"

namespace softwet {

template <int D>
Snapshot<D>::Snapshot(const Layout<D>& layout, const State& state)
    : layout_(layout.whole_patch()),
      unknown_(to_host_of_patch(layout, state.unknown)),
      displacement_(to_host_of_patch(layout, state.displacement)) {}

template <int D>
std::vector<double> Snapshot<D>::component(const double* box, int rows, const Grid& grid, int shift, int lowest,
                                           int highest, int derivative) const {
  std::array<int, D> extent;
  std::array<AxisSamples, D> at;
  for (int d = 0; d < D; ++d) {
    const bool last = d == D - 1;
    extent[d] = last ? rows : layout_.axis[d].functions();
    at[d] =
        last ? sample_axis(layout_.axis[d], grid[d], shift, lowest, highest) : sample_axis(layout_.axis[d], grid[d]);
  }
  return evaluate_grid<D>(box, extent, at, derivative);
}

template <int D>
std::vector<double> Snapshot<D>::velocity(const Grid& grid, int d, bool in_fluid) const {
  const int all = layout_.axis[D - 1].elements();
  return component(unknown_.data() + layout_.velocity_offset(d), layout_.rows, grid, 0,
                   in_fluid ? layout_.solid_elements : 0, in_fluid ? all : layout_.solid_elements);
}

template <int D>
std::vector<double> Snapshot<D>::density(const Grid& grid, int derivative) const {
  return component(unknown_.data() + layout_.density_offset(), layout_.fluid_rows(), grid, layout_.wall_row,
                   layout_.solid_elements, layout_.axis[D - 1].elements(), derivative);
}

template <int D>
std::vector<double> Snapshot<D>::chemical_potential(const Grid& grid) const {
  return component(unknown_.data() + layout_.potential_offset(), layout_.fluid_rows(), grid, layout_.wall_row,
                   layout_.solid_elements, layout_.axis[D - 1].elements());
}

template <int D>
std::vector<double> Snapshot<D>::displacement(const Grid& grid, int d, bool in_fluid) const {
  std::size_t wall_points = 1;
  for (int a = 0; a < D - 1; ++a) wall_points *= grid[a].size();
  if (!layout_.has_solid) return std::vector<double>(wall_points * grid[D - 1].size(), 0.0);
  const double* box = displacement_.data() + layout_.displacement_offset(d);
  if (!in_fluid) return component(box, layout_.solid_rows(), grid, 0, 0, layout_.solid_elements);
  Grid wall = grid;
  wall[D - 1] = {wall_height()};
  const std::vector<double> trace = component(box, layout_.solid_rows(), wall, 0, 0, layout_.solid_elements);
  const Blend blend{wall_height(), layout_.axis[D - 1].length() - wall_height()};
  std::vector<double> result;
  for (double y : grid[D - 1])
    for (double u : trace) result.push_back(blend.value(y) * u);
  return result;
}

template <int D>
std::vector<double> Snapshot<D>::displacement_gradient(const Grid& grid, int d, int axis) const {
  return component(displacement_.data() + layout_.displacement_offset(d), layout_.solid_rows(), grid, 0, 0,
                   layout_.solid_elements, axis);
}

template <int D>
double Snapshot<D>::extreme(int first, int count, int sign) const {
  const auto begin = unknown_.begin() + first, end = begin + count;
  if (count == 0) return 0;
  return sign > 0 ? *std::max_element(begin, end) : *std::min_element(begin, end);
}

template <int D>
double Snapshot<D>::speed_max(bool in_fluid) const {
  const int first = in_fluid ? layout_.wall_row : 0, last = in_fluid ? layout_.rows : layout_.solid_rows();
  double largest = 0;
  for (int i = first * layout_.row_size; i < last * layout_.row_size; ++i) {
    double square = 0;
    for (int d = 0; d < D; ++d) square += std::pow(unknown_[layout_.velocity_offset(d) + i], 2);
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

template <int D>
double Snapshot<D>::speed_max_above(double density) const {
  double largest = 0;
  for (int i = 0; i < layout_.scalar_size(); ++i) {
    if (!(unknown_[layout_.density_offset() + i] > density)) continue;
    double square = 0;
    for (int d = 0; d < D; ++d) square += std::pow(unknown_[layout_.velocity_offset(d) + layout_.fluid_shift() + i], 2);
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

template class Snapshot<2>;
template class Snapshot<3>;

}  // namespace softwet
