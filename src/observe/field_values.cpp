#include "observe/field_values.hpp"

#include <variant>

#include "observe/host/places.hpp"
#include "scene/beside_joint.hpp"

namespace softwet {
namespace {

template <int D>
std::vector<double> vector_field(const auto& component) {
  std::vector<double> values;
  for (int d = 0; d < D; ++d) {
    const std::vector<double> along = component(d);
    values.resize(D * along.size());
    for (std::size_t i = 0; i < along.size(); ++i) values[D * i + d] = along[i];
  }
  return values;
}

/// Grad u of the solid at the points of a grid. In 2D the third row and column are 0, plane strain, but in the
/// coordinates (r, z) for u_r / r, which is du_r/dr at the axis.
template <int D>
std::vector<Matrix<double, 3>> displacement_gradients(const Snapshot<D>& s, const typename Snapshot<D>::Grid& grid,
                                                      ElementRows rows) {
  std::vector<Matrix<double, 3>> gradients;
  for (int d = 0; d < D; ++d)
    for (int axis = 0; axis < D; ++axis) {
      const std::vector<double> slope = s.displacement_gradient(grid, d, axis, rows);
      gradients.resize(slope.size(), Matrix<double, 3>{});
      for (std::size_t i = 0; i < slope.size(); ++i) gradients[i](d, axis) = slope[i];
    }
  if (!s.layout().axisymmetric()) return gradients;
  const std::vector<double> radial = s.displacement(grid, 0, Medium::solid);
  const double element = s.layout().axis[0].spacing();
  for (std::size_t i = 0; i < radial.size(); ++i) {
    const double r = grid[0][i % grid[0].size()];
    gradients[i](2, 2) = at_end(r, 0, element) ? gradients[i](0, 0) : radial[i] / r;
  }
  return gradients;
}

}  // namespace

template <int D>
const std::vector<Matrix<double, 3>>& FieldValues<D>::gradients() {
  if (gradients_.empty()) gradients_ = displacement_gradients(snapshot_, grid_, rows_);
  return gradients_;
}

template <int D>
std::vector<double> FieldValues<D>::of(const std::string& field) {
  if (field == "velocity") return vector_field<D>([&](int d) { return snapshot_.velocity(grid_, d, medium_); });
  if (field == "displacement") return vector_field<D>([&](int d) { return snapshot_.displacement(grid_, d, medium_); });
  if (field == "density") return snapshot_.density(grid_);
  if (field == "chemical_potential") return snapshot_.chemical_potential(grid_);
  if (field == "pressure") {
    std::vector<double> pressure = snapshot_.density(grid_);
    for (double& value : pressure) value = coefficients_.fluid().gas.pressure(value);
    return pressure;
  }
  if (field == "volume_ratio") {
    std::vector<double> ratio;
    for (const auto& gradient : gradients()) ratio.push_back(volume_ratio(gradient));
    return ratio;
  }
  return tensor(field);
}

template <int D>
std::vector<double> FieldValues<D>::tensor(const std::string& field) {
  const bool strain = field == "green_lagrange_strain";
  // Where strains are small there is one stress.
  const bool cauchy =
      field == "cauchy_stress" && !std::holds_alternative<Elastodynamics<Hooke>>(coefficients_.solid().law);
  std::vector<double> values;
  for (std::size_t i = 0; i < gradients().size(); ++i) {
    const Matrix<double, 3>& gradient = gradients()[i];
    Matrix<double, 3> tensor =
        strain ? green_lagrange_strain(gradient) : coefficients_.solid().first_piola(gradient, place(i));
    if (cauchy) tensor = cauchy_stress(tensor, gradient);
    for (int row = 0; row < 3; ++row) values.insert(values.end(), tensor.c[row], tensor.c[row] + 3);
  }
  return values;
}

template <int D>
std::array<double, 3> FieldValues<D>::place(std::size_t point) const {
  std::array<double, 3> x{};
  for (int d = 0; d < D; ++d) {
    x[d] = grid_[d][point % grid_[d].size()];
    point /= grid_[d].size();
  }
  const Axis& vertical = snapshot_.layout().axis[D - 1];
  x[D - 1] = height_in_part(vertical, rows_.first < vertical.joint() ? 0 : 1, x[D - 1]);
  return x;
}

template class FieldValues<2>;
template class FieldValues<3>;

}  // namespace softwet
