#include "observe/probes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "observe/field_values.hpp"
#include "observe/host/places.hpp"
#include "observe/host/probe_quantity.hpp"
#include "scene/beside_joint.hpp"

namespace softwet {
namespace {

constexpr double no_extent = 1e-12;  ///< share of the length of an axis
constexpr int looks = 4;  ///< parts of an element, at whose ends the largest and smallest values are looked for

/// Points along an axis, and their weights.
struct LinePoints {
  std::vector<double> point, weight;
};

/// The parts of elements between two places. @param of_part  gives points and weights on the line from 0 to 1
LinePoints points_along(const Axis& axis, double low, double high, const LinePoints& of_part) {
  low = std::clamp(low, 0.0, axis.length()), high = std::clamp(high, 0.0, axis.length());
  if (high - low <= no_extent * axis.length()) return {{low}, {1.0}};
  LinePoints all;
  for (int e = 0; e < axis.elements(); ++e) {
    const double from = std::max(low, axis.lower(e)), to = std::min(high, axis.lower(e) + axis.size(e));
    if (to - from <= no_extent * axis.length()) continue;
    for (std::size_t i = 0; i < of_part.point.size(); ++i) {
      all.point.push_back(from + (to - from) * of_part.point[i]);
      all.weight.push_back((to - from) * of_part.weight[i]);
    }
  }
  return all;
}

/// The points at which a probe looks, in the elements of one material, or of one side of a joint.
template <int D>
struct ProbeSite {
  typename Snapshot<D>::Grid grid;
  std::array<std::vector<double>, D> weight;
  ElementRows rows{0, 0};
  bool in_fluid = false;

  std::size_t size() const {
    std::size_t n = 1;
    for (const auto& points : grid) n *= points.size();
    return n;
  }
  bool extends(int d) const { return grid[d].size() > 1; }
};

bool sums_up(ProbeOperation operation) {
  return operation == ProbeOperation::mean || operation == ProbeOperation::integral;
}

/// Points and weights on the line from 0 to 1: ends and places between them, or for means and integrals Gauss points.
LinePoints points_of_part(ProbeOperation operation, int gauss_points) {
  LinePoints part{{}, std::vector<double>(looks + 1, 0.0)};
  for (int i = 0; i <= looks; ++i) part.point.push_back(static_cast<double>(i) / looks);
  if (!sums_up(operation)) return part;
  const Gauss gauss(gauss_points);
  return {gauss.point, gauss.weight};
}

/// The parts of a place along the vertical axis, each in elements of one side: a place that ends at the joint of a
/// solid lies on its own side, one without height at the joint above it.
template <int D>
std::vector<ElementRows> sides_of(const Probe& probe, const Snapshot<D>& s) {
  const Layout<D>& layout = s.layout();
  const Axis& vertical = layout.axis[D - 1];
  const FieldInfo& field = *probe_quantity(probe.quantity).field;
  const double low = probe.low()[D - 1], high = probe.high()[D - 1], room = one_height * vertical.length();
  if (!layout.has_solid || !field.in_solid || (field.in_fluid && high > s.wall_height() + room))
    return {s.fluid_rows()};
  std::vector<ElementRows> sides = s.solid_parts();
  if (sides.size() == 1) return sides;
  const double joint = vertical.lower(vertical.joint());
  if (low >= joint - room) return {sides[1]};
  if (high <= joint + room) return {sides[0]};
  return sides;
}

template <int D>
std::vector<ProbeSite<D>> sites_of(const Probe& probe, const Snapshot<D>& s, int gauss_points) {
  const Layout<D>& layout = s.layout();
  const LinePoints part = points_of_part(probe.operation, gauss_points);
  std::vector<ProbeSite<D>> sites;
  for (const ElementRows rows : sides_of(probe, s)) {
    ProbeSite<D>& site = sites.emplace_back();
    site.rows = rows;
    site.in_fluid = rows.first >= layout.solid_elements;
    for (int d = 0; d < D; ++d) {
      double low = probe.low()[d], high = probe.high()[d];
      if (d == D - 1 && layout.axis[d].joint() > 0) {
        low = std::max(low, layout.axis[d].lower(rows.first));
        high = std::min(high, layout.axis[d].lower(rows.last));
      }
      const LinePoints samples = points_along(layout.axis[d], low, high, part);
      site.grid[d] = samples.point;
      site.weight[d] = samples.weight;
    }
  }
  return sites;
}

/// The deformed over the undeformed measure of a box, face or line in the fluid, at each of its points.
template <int D>
std::vector<double> measures(const Regions<D>& regions, const Snapshot<D>& s, const ProbeSite<D>& site) {
  std::vector<double> measure(site.size(), 1.0);
  if (!s.layout().has_solid) return measure;
  typename Snapshot<D>::Grid wall = site.grid;
  wall[D - 1] = {regions.wall_height()};
  std::array<std::vector<double>, D> u;
  std::array<std::array<std::vector<double>, D>, D> slope;
  for (int d = 0; d < D; ++d) {
    u[d] = s.displacement(wall, d, Medium::solid);
    for (int axis = 0; axis < D - 1; ++axis) slope[d][axis] = s.displacement_gradient(wall, d, axis, s.solid_rows());
  }
  for (std::size_t i = 0; i < measure.size(); ++i) {
    const std::size_t below = i % u[0].size();
    const double share = regions.blend().value(site.grid[D - 1][i / u[0].size()]);
    Eigen::Matrix<double, D, Eigen::Dynamic, 0, D, D> tangents(D, 0);  // of the axes along which the place extends
    for (int axis = 0; axis < D; ++axis) {
      if (!site.extends(axis)) continue;
      tangents.conservativeResize(Eigen::NoChange, tangents.cols() + 1);
      for (int d = 0; d < D; ++d)
        tangents(d, tangents.cols() - 1) =
            (d == axis) + (axis < D - 1 ? share * slope[d][axis][below] : regions.blend().slope() * u[d][below]);
    }
    if (tangents.cols() > 0) measure[i] = std::sqrt((tangents.transpose() * tangents).determinant());
  }
  return measure;
}

/// What each point counts in an integral. A whole turn makes a circle of a point and a face of a line, but on the axis
/// of symmetry both stay what they are.
template <int D>
std::vector<double> weights(const Regions<D>& regions, const Snapshot<D>& s, const ProbeSite<D>& site) {
  std::vector<double> weight(site.size(), 1.0), moved;
  if (site.in_fluid) weight = measures(regions, s, site);
  const bool on_axis = !site.extends(0) && at_end(site.grid[0][0], 0, s.layout().axis[0].spacing());
  const bool axial = s.layout().axisymmetric() && !on_axis;
  if (axial) moved = s.displacement(site.grid, 0, site.in_fluid ? Medium::fluid : Medium::solid);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (axial) {
      const double r = site.grid[0][i % site.grid[0].size()] + (site.in_fluid ? moved[i] : 0);
      weight[i] *= regions.turn() * s.layout().axis[0].weight(r);
    }
    std::size_t rest = i;
    for (int d = 0; d < D; ++d) {
      weight[i] *= site.weight[d][rest % site.grid[d].size()];
      rest /= site.grid[d].size();
    }
  }
  return weight;
}

/// The quantity at each point.
template <int D>
std::vector<double> values_of(const ProbeQuantity& quantity, const Case& c, const Coefficients<D>& coefficients,
                              const Snapshot<D>& s, const ProbeSite<D>& site) {
  const std::vector<double> field = FieldValues<D>(c, coefficients, s, site.grid, site.rows).of(quantity.field->name);
  const std::size_t components = field.size() / site.size();
  std::vector<double> values(site.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double* at = &field[components * i];
    double square = 0;
    for (std::size_t k = 0; quantity.magnitude && k < components; ++k) square += at[k] * at[k];
    values[i] = quantity.magnitude ? std::sqrt(square) : at[quantity.component];
  }
  return values;
}

template <int D>
double evaluate(const Probe& probe, const Case& c, const Regions<D>& regions, const Coefficients<D>& coefficients,
                const Snapshot<D>& s) {
  std::vector<double> values, weight;
  for (const ProbeSite<D>& site : sites_of(probe, s, regions.points())) {
    append(values_of(probe_quantity(probe.quantity), c, coefficients, s, site), values);
    if (sums_up(probe.operation)) append(weights(regions, s, site), weight);
  }
  if (probe.operation == ProbeOperation::value) return values[0];
  if (probe.operation == ProbeOperation::max) return *std::max_element(values.begin(), values.end());
  if (probe.operation == ProbeOperation::min) return *std::min_element(values.begin(), values.end());
  double sum = 0, measure = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weight[i] * values[i], measure += weight[i];
  return probe.operation == ProbeOperation::integral ? sum : sum / measure;
}

}  // namespace

template <int D>
std::vector<double> evaluate_probes(const Case& c, const Regions<D>& regions, const Coefficients<D>& coefficients,
                                    const Snapshot<D>& snapshot) {
  std::vector<double> numbers;
  for (const Probe& probe : c.probes) numbers.push_back(evaluate(probe, c, regions, coefficients, snapshot));
  return numbers;
}

template std::vector<double> evaluate_probes(const Case&, const Regions<2>&, const Coefficients<2>&,
                                             const Snapshot<2>&);
template std::vector<double> evaluate_probes(const Case&, const Regions<3>&, const Coefficients<3>&,
                                             const Snapshot<3>&);

}  // namespace softwet
