#include "observe/probes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "observe/field_values.hpp"
#include "observe/host/probe_quantity.hpp"

namespace softwet {
namespace {

constexpr int looks = 4;  ///< parts of an element, at whose ends the largest and smallest values are looked for

/// Points along an axis, and their weights.
struct LinePoints {
  std::vector<double> point, weight;
};

/// The parts of elements between two places. @param of_part  gives points and weights on the line from 0 to 1
LinePoints points_along(const Axis& axis, double low, double high, const LinePoints& of_part) {
  low = std::clamp(low, 0.0, axis.length()), high = std::clamp(high, 0.0, axis.length());
  if (high - low <= 1e-12 * axis.length()) return {{low}, {1.0}};
  LinePoints all;
  for (int e = 0; e < axis.elements(); ++e) {
    const double from = std::max(low, axis.lower(e)), to = std::min(high, axis.lower(e) + axis.size(e));
    if (to - from <= 1e-12 * axis.length()) continue;
    for (std::size_t i = 0; i < of_part.point.size(); ++i) {
      all.point.push_back(from + (to - from) * of_part.point[i]);
      all.weight.push_back((to - from) * of_part.weight[i]);
    }
  }
  return all;
}

/// The points at which a probe looks.
template <int D>
struct ProbeSite {
  typename Snapshot<D>::Grid grid;
  std::array<std::vector<double>, D> weight;
  bool in_fluid = false;

  std::size_t size() const {
    std::size_t n = 1;
    for (const auto& points : grid) n *= points.size();
    return n;
  }
  bool extends(int d) const { return grid[d].size() > 1; }
};

template <int D, int P>
ProbeSite<D> site_of(const Probe& probe, const Model<D, P>& model) {
  const Layout<D>& layout = model.layout();
  const FieldInfo& field = *probe_quantity(probe.quantity).field;
  LinePoints part{{}, std::vector<double>(looks + 1, 0.0)};
  for (int i = 0; i <= looks; ++i) part.point.push_back(static_cast<double>(i) / looks);
  const Gauss gauss(model.points());
  if (probe.operation == ProbeOperation::mean || probe.operation == ProbeOperation::integral)
    part = {gauss.point, gauss.weight};
  ProbeSite<D> site;
  for (int d = 0; d < D; ++d) {
    const LinePoints samples = points_along(layout.axis[d], probe.low()[d], probe.high()[d], part);
    site.grid[d] = samples.point;
    site.weight[d] = samples.weight;
  }
  const double wall = model.wall_height(), room = 1e-9 * layout.axis[D - 1].length();
  site.in_fluid = !layout.has_solid || !field.in_solid || (field.in_fluid && probe.high()[D - 1] > wall + room);
  return site;
}

/// The deformed over the undeformed measure of a box, face or line in the fluid, at each of its points.
template <int D, int P>
std::vector<double> measures(const Model<D, P>& model, const Snapshot<D>& s, const ProbeSite<D>& site) {
  std::vector<double> measure(site.size(), 1.0);
  if (!s.layout().has_solid) return measure;
  typename Snapshot<D>::Grid wall = site.grid;
  wall[D - 1] = {model.wall_height()};
  std::array<std::vector<double>, D> u;
  std::array<std::array<std::vector<double>, D>, D> slope;
  for (int d = 0; d < D; ++d) {
    u[d] = s.displacement(wall, d, false);
    for (int axis = 0; axis < D - 1; ++axis) slope[d][axis] = s.displacement_gradient(wall, d, axis);
  }
  for (std::size_t i = 0; i < measure.size(); ++i) {
    const std::size_t below = i % u[0].size();
    const double share = model.blend().value(site.grid[D - 1][i / u[0].size()]);
    Eigen::Matrix<double, D, Eigen::Dynamic, 0, D, D> tangents(D, 0);  // of the axes along which the place extends
    for (int axis = 0; axis < D; ++axis) {
      if (!site.extends(axis)) continue;
      tangents.conservativeResize(Eigen::NoChange, tangents.cols() + 1);
      for (int d = 0; d < D; ++d)
        tangents(d, tangents.cols() - 1) =
            (d == axis) + (axis < D - 1 ? share * slope[d][axis][below] : model.blend().slope() * u[d][below]);
    }
    if (tangents.cols() > 0) measure[i] = std::sqrt((tangents.transpose() * tangents).determinant());
  }
  return measure;
}

/// What each point counts in an integral.
template <int D, int P>
std::vector<double> weights(const Model<D, P>& model, const Snapshot<D>& s, const ProbeSite<D>& site) {
  std::vector<double> weight(site.size(), 1.0), moved;
  if (site.in_fluid) weight = measures(model, s, site);
  const bool axial = s.layout().axisymmetric;
  if (axial) moved = s.displacement(site.grid, 0, site.in_fluid);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (axial) weight[i] *= model.turn() * (site.grid[0][i % site.grid[0].size()] + (site.in_fluid ? moved[i] : 0));
    std::size_t rest = i;
    for (int d = 0; d < D; ++d) {
      weight[i] *= site.weight[d][rest % site.grid[d].size()];
      rest /= site.grid[d].size();
    }
  }
  return weight;
}

/// The quantity at each point.
template <int D, int P>
std::vector<double> values_of(const ProbeQuantity& quantity, const Model<D, P>& model, const Snapshot<D>& s,
                              const ProbeSite<D>& site) {
  const std::vector<double> field = FieldValues<D, P>(model, s, site.grid, site.in_fluid).of(quantity.field->name);
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

template <int D, int P>
double evaluate(const Probe& probe, const Model<D, P>& model, const Snapshot<D>& s) {
  const ProbeSite<D> site = site_of(probe, model);
  const std::vector<double> values = values_of(probe_quantity(probe.quantity), model, s, site);
  if (probe.operation == ProbeOperation::value) return values[0];
  if (probe.operation == ProbeOperation::max) return *std::max_element(values.begin(), values.end());
  if (probe.operation == ProbeOperation::min) return *std::min_element(values.begin(), values.end());
  const std::vector<double> weight = weights(model, s, site);
  double sum = 0, measure = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weight[i] * values[i], measure += weight[i];
  if (probe.operation == ProbeOperation::integral) return sum;
  return measure > 0 ? sum / measure : values[0];  // a point on the axis of symmetry
}

}  // namespace

template <int D, int P>
std::vector<double> evaluate_probes(const Case& c, const Model<D, P>& model, const Snapshot<D>& snapshot) {
  std::vector<double> numbers;
  for (const Probe& probe : c.probes) numbers.push_back(evaluate<D, P>(probe, model, snapshot));
  return numbers;
}

template std::vector<double> evaluate_probes(const Case&, const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                             const Snapshot<SOFTWET_DIMENSION>&);

}  // namespace softwet
