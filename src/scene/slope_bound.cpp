#include "scene/slope_bound.hpp"

#include "field/ranks.hpp"
#include "memory/start_teams.hpp"

namespace softwet {
namespace {

/// Slopes over differences of control values. Neighbours that do not follow each other on the axis share no element.
std::vector<double> slopes_per_step(const Axis& axis, const std::vector<int>& function) {
  std::vector<double> all(function.size(), 0.0);
  const int degree = axis.degree();
  const std::vector<double>& knot = axis.knots();
  for (std::size_t i = 0; i + 1 < function.size(); ++i) {
    const int f = function[i];
    if (function[i + 1] != f + 1) continue;
    const double support = knot[f + degree + 1] - knot[f + 1];
    if (support > 0) all[i] = degree / support;
  }
  return all;
}

}  // namespace

template <int D, int P>
SlopeBound<D, P>::SlopeBound(const Regions<D>& regions) : regions_(regions) {
  const Layout<D>& l = regions.layout();
  if (!l.has_solid) return;
  for (int d = 0; d < D; ++d) {
    std::vector<int> function;
    for (int i = 0; i < (d < D - 1 ? l.extent(d) : l.solid_rows()); ++i) function.push_back(l.function(i, d));
    per_step_[d] = to_device<Array>(slopes_per_step(l.axis[d], function), "slope_bound");
    if (d > 0) continue;
    std::vector<double> on_axis;
    for (const int f : function) on_axis.push_back(f == 0 ? 1 : 0);
    on_axis_ = to_device<Array>(on_axis, "slope_bound");
  }
}

template <int D, int P>
void SlopeBound<D, P>::ask(const Stage& stage, const Array& numbers) const {
  const Layout<D>& l = regions_.layout();
  const int nodes = l.solid_rows() * l.row_size;
  LargestSlopes<D> largest{.displacement = stage.displacement.data(),
                           .per_step = {},
                           .extent = {},
                           .nodes = nodes,
                           .wall = l.wall_shift(),
                           .axisymmetric = l.axisymmetric(),
                           .on_axis = on_axis_};
  for (int d = 0; d < D; ++d) {
    largest.per_step[d] = per_step_[d];
    largest.extent[d] = d < D - 1 ? l.extent(d) : l.solid_rows();
  }
  Kokkos::parallel_reduce("softwet::largest_slopes", SmallBlocks(0, nodes), largest, numbers);
}

template <int D, int P>
bool SlopeBound<D, P>::excludes_faults(const double* numbers) const {
  constexpr double enough = 0.9;  // and not 1: far above rounding errors of determinants
  using Largest = LargestSlopes<D>;
  std::array<double, Largest::count> most;
  std::copy_n(numbers, int(Largest::count), most.begin());
  ranks::largest(most.data(), Largest::count);
  double solid = 0;
  for (int d = 0; d < D; ++d) solid += most[d];
  if (!(solid < enough)) return false;
  if (!regions_.layout().has_fluid) return true;
  const double slope = regions_.blend().slope();
  double fluid = slope * slope * most[Largest::at_wall];
  for (int d = 0; d + 1 < D; ++d) fluid += most[Largest::along_wall + d];
  return fluid < enough;
}

template class SlopeBound<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
