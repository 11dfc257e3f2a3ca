#include "observe/solid_gradients.hpp"

#include "observe/host/places.hpp"
#include "scene/beside_joint.hpp"
#include "spline/means.hpp"

namespace softwet {
namespace {

/// Gradients of a vector field: slope(d, axis) has its values at all points, and value(d) the values of a component. In
/// 2D the third row and column are 0, plane strain, except in the coordinates (r, z) for v_r / r, which is dv_r/dr at
/// the axis.
template <int D, class Slope, class Value>
std::vector<Matrix<double, 3>> gradients_from(const SolidPoints<D>& at, const Slope& slope, const Value& value) {
  std::vector<Matrix<double, 3>> gradients(at.size(), Matrix<double, 3>{});
  for (int d = 0; d < D; ++d)
    for (int axis = 0; axis < D; ++axis) {
      const std::vector<double> slopes = slope(d, axis);
      for (std::size_t i = 0; i < slopes.size(); ++i) gradients[i](d, axis) = slopes[i];
    }
  if (!at.snapshot.layout().axisymmetric()) return gradients;
  const std::vector<double> radial = value(0);
  const double element = at.snapshot.layout().axis[0].spacing();
  for (std::size_t i = 0; i < radial.size(); ++i) {
    const double r = at.grid[0][i % at.grid[0].size()];
    gradients[i](2, 2) = at_end(r, 0, element) ? gradients[i](0, 0) : radial[i] / r;
  }
  return gradients;
}

enum class Mean { value, slope };

/// The means over elements as samples of an axis.
AxisSamples mean_samples(const Axis& axis, const std::vector<int>& elements, Mean mean, MeanWeight weight) {
  AxisSamples samples{axis.degree() + 1, {}, {}};
  for (const int e : elements) {
    const Living living = means_of(axis, e, weight);
    const std::vector<double>& weights = mean == Mean::value ? living.values : living.slopes;
    samples.first.push_back(axis.span(e));
    samples.weight.insert(samples.weight.end(), weights.begin(), weights.end());
  }
  return samples;
}

}  // namespace

template <int D>
std::array<double, 3> SolidPoints<D>::place(std::size_t point) const {
  std::array<double, 3> x{};
  for (int d = 0; d < D; ++d) {
    x[d] = grid[d][point % grid[d].size()];
    point /= grid[d].size();
  }
  const Axis& vertical = snapshot.layout().axis[D - 1];
  x[D - 1] = height_in_part(vertical, rows.first < vertical.joint() ? 0 : 1, x[D - 1]);
  return x;
}

template <int D>
std::vector<Matrix<double, 3>> displacement_gradients(const SolidPoints<D>& at) {
  return gradients_from<D>(
      at, [&](int d, int axis) { return at.snapshot.displacement_gradient(at.grid, d, axis, at.rows); },
      [&](int d) { return at.snapshot.displacement(at.grid, d, Medium::solid); });
}

template <int D>
std::vector<Matrix<double, 3>> velocity_gradients(const SolidPoints<D>& at) {
  return gradients_from<D>(
      at, [&](int d, int axis) { return at.snapshot.velocity_gradient(at.grid, d, axis, at.rows); },
      [&](int d) { return at.snapshot.velocity(at.grid, d, Medium::solid); });
}

template <int D>
std::vector<Matrix<double, 3>> branch_gradients(const SolidPoints<D>& at, int branch) {
  return gradients_from<D>(
      at, [&](int d, int axis) { return at.snapshot.branch_gradient(at.grid, branch, d, axis, at.rows); },
      [&](int d) { return at.snapshot.branch_displacement(at.grid, branch, d); });
}

template <int D>
std::vector<Matrix<double, 3>> mean_gradients(const Snapshot<D>& s, const std::array<std::vector<int>, D>& elements) {
  std::array<AxisSamples, D> value, slope;
  typename Snapshot<D>::Grid middles;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = s.layout().axis[d];
    const bool radial = d == 0 && s.layout().axisymmetric();
    const MeanWeight weight = radial ? MeanWeight::radius : MeanWeight::uniform;
    value[d] = mean_samples(axis, elements[d], Mean::value, weight);
    slope[d] = mean_samples(axis, elements[d], Mean::slope, weight);
    for (const int e : elements[d]) middles[d].push_back(axis.lower(e) + axis.size(e) / 2);
  }
  const auto along = [&](int d, int axis) {
    std::array<AxisSamples, D> samples = value;
    samples[axis] = slope[axis];
    return s.displacement(samples, d);
  };
  return gradients_from<D>({s, middles, s.solid_rows()}, along, [&](int d) { return s.displacement(value, d); });
}

template struct SolidPoints<2>;
template struct SolidPoints<3>;
template std::vector<Matrix<double, 3>> displacement_gradients(const SolidPoints<2>&);
template std::vector<Matrix<double, 3>> displacement_gradients(const SolidPoints<3>&);
template std::vector<Matrix<double, 3>> velocity_gradients(const SolidPoints<2>&);
template std::vector<Matrix<double, 3>> velocity_gradients(const SolidPoints<3>&);
template std::vector<Matrix<double, 3>> branch_gradients(const SolidPoints<2>&, int);
template std::vector<Matrix<double, 3>> branch_gradients(const SolidPoints<3>&, int);
template std::vector<Matrix<double, 3>> mean_gradients<2>(const Snapshot<2>&, const std::array<std::vector<int>, 2>&);
template std::vector<Matrix<double, 3>> mean_gradients<3>(const Snapshot<3>&, const std::array<std::vector<int>, 3>&);

}  // namespace softwet
