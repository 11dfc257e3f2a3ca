#include "observe/interface_table.hpp"

#include "field/exchange.hpp"
#include "field/ranks.hpp"
#include "field/vector.hpp"

namespace softwet {
namespace {

/// Integrals of the wall's functions; a ghost of a periodic axis has the integral of the function that it copies.
template <int D>
std::vector<double> wall_weights(const Layout<D>& layout) {
  std::vector<double> weight(layout.row_size, 1.0);
  int stride = 1;
  for (int d = 0; d < D - 1; ++d) {
    const Axis& axis = layout.axis[d];
    std::vector<double> factor = axis.integrals(0, axis.length(), 0, axis.elements());
    for (int g = axis.owned(); g < axis.functions(); ++g) factor[g - axis.owned()] += factor[g];
    for (int g = axis.owned(); g < axis.functions(); ++g) factor[g] = factor[g - axis.owned()];
    for (int i = 0; i < layout.row_size; ++i) weight[i] *= factor[(i / stride) % axis.functions()];
    stride *= axis.functions();
  }
  return weight;
}

/// Sets a component along the axis `d` to zero where that axis ends.
template <int D>
void clear_ends(const Layout<D>& layout, int d, std::vector<double>& values) {
  if (d == D - 1 || layout.axis[d].periodic()) return;
  int stride = 1;
  for (int a = 0; a < d; ++a) stride *= layout.axis[a].functions();
  const int n = layout.axis[d].functions();
  for (int i = 0; i < layout.row_size; ++i) {
    const int index = (i / stride) % n;
    if (index == 0 || index == n - 1) values[i] = 0;
  }
}

/// A spline of the wall, given by its control values, at a grid of points of the wall.
template <int D>
std::vector<double> on_wall(const Layout<D>& layout, const std::vector<double>& values,
                            const typename Snapshot<D>::Grid& wall) {
  std::array<int, D> extent;
  std::array<AxisSamples, D> at;
  for (int d = 0; d < D - 1; ++d) {
    extent[d] = layout.axis[d].functions();
    at[d] = sample_axis(layout.axis[d], wall[d]);
  }
  extent[D - 1] = 1;
  at[D - 1] = {1, {0}, {1.0}};
  return evaluate_grid<D>(values.data(), extent, at);
}

}  // namespace

template <int D, int P>
std::array<std::vector<double>, D> wall_traction(const Regions<D>& regions, const Equations<D, P>& equations,
                                                 const Stage& stage) {
  const Layout<D>& own = regions.layout();
  std::array<std::vector<double>, D> traction;
  if (!own.has_fluid || !regions.has_wall()) return traction;
  const Array residual("fluid_residual", own.size());
  equations.fluid_residual(stage, residual);
  move_ghosts(own, residual, GhostAction::update);
  for (int d = 0; d < D; ++d) {
    const int first = own.velocity_offset(d) + own.wall_shift();
    traction[d] = to_host_on_root(own, part(residual, first, first + own.row_size));
  }
  if (!ranks::root()) return traction;
  const Layout<D> layout = own.whole_patch();
  const std::vector<double> weight = wall_weights(layout);
  for (int d = 0; d < D; ++d) {
    for (int i = 0; i < layout.row_size; ++i) traction[d][i] = -traction[d][i] / weight[i];
    clear_ends(layout, d, traction[d]);
  }
  return traction;
}

template <int D>
void add_interface_rows(TableFile& table, const Snapshot<D>& snapshot,
                        const std::array<std::vector<double>, D>& traction, double time) {
  const Layout<D>& layout = snapshot.layout();
  typename Snapshot<D>::Grid wall;
  for (int d = 0; d < D - 1; ++d)
    for (int i = 0; i <= 2 * layout.axis[d].elements(); ++i) wall[d].push_back(layout.axis[d].end_or_middle(i));
  wall[D - 1] = {snapshot.wall_height()};
  std::array<std::vector<double>, D> displacement;
  for (int d = 0; d < D; ++d) displacement[d] = snapshot.displacement(wall, d, Medium::solid);
  std::vector<double> density;
  if (layout.has_fluid) density = snapshot.density(wall);
  const bool loaded = !traction[0].empty();
  const std::string axis[] = {"x", "y", "z"};
  std::array<std::vector<double>, D> force;
  for (int d = 0; loaded && d < D; ++d) force[d] = on_wall<D>(layout, traction[d], wall);
  for (std::size_t i = 0; i < displacement[0].size(); ++i) {
    TableRow row{{"time", time}};
    std::size_t rest = i;
    for (int d = 0; d < D - 1; ++d) {
      row.set(axis[d] + "_reference", wall[d][rest % wall[d].size()]);
      rest /= wall[d].size();
    }
    for (int d = 0; d < D; ++d) row.set("displacement_" + axis[d], displacement[d][i]);
    row.set("density", layout.has_fluid ? TableRow::Cell(density[i]) : std::nullopt);
    for (int d = 0; d < D; ++d) row.set("traction_" + axis[d], loaded ? TableRow::Cell(force[d][i]) : std::nullopt);
    table.row(row);
  }
}

template std::array<std::vector<double>, SOFTWET_DIMENSION> wall_traction<SOFTWET_DIMENSION, SOFTWET_DEGREE>(
    const Regions<SOFTWET_DIMENSION>&, const Equations<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Stage&);
template void add_interface_rows<SOFTWET_DIMENSION>(TableFile&, const Snapshot<SOFTWET_DIMENSION>&,
                                                    const std::array<std::vector<double>, SOFTWET_DIMENSION>&, double);

}  // namespace softwet
