#include "observe/field_values.hpp"

#include <variant>

#include "observe/acting_stress.hpp"

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

}  // namespace

template <int D>
const std::vector<Matrix<double, 3>>& FieldValues<D>::gradients() {
  if (gradients_.empty()) gradients_ = displacement_gradients<D>({snapshot_, grid_, rows_});
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
  std::vector<Matrix<double, 3>> stress;
  if (!strain) stress = acting_stress<D>({snapshot_, grid_, rows_}, gradients(), case_, coefficients_.solid());
  std::vector<double> values;
  for (std::size_t i = 0; i < gradients().size(); ++i) {
    const Matrix<double, 3>& gradient = gradients()[i];
    Matrix<double, 3> tensor = strain ? green_lagrange_strain(gradient) : stress[i];
    if (cauchy) tensor = cauchy_stress(tensor, gradient);
    for (int row = 0; row < 3; ++row) values.insert(values.end(), tensor.c[row], tensor.c[row] + 3);
  }
  return values;
}

template class FieldValues<2>;
template class FieldValues<3>;

}  // namespace softwet
