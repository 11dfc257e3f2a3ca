#include "observe/host/field_table.hpp"

#include <algorithm>

namespace softwet {

const std::vector<FieldInfo>& field_table() {
  using enum FieldShape;
  static const std::vector<FieldInfo> table{
      {"velocity", vector, true, true, "sqrt(ab)", "velocity of the material"},
      {"density", scalar, true, false, "b", "mass per volume"},
      {"chemical_potential", scalar, true, false, "a b", "chemical potential W'(rho) - gamma^2 Laplacian(rho)"},
      {"pressure", scalar, true, false, "a b^2", "pressure of the van der Waals fluid of this density"},
      {"displacement", vector, false, true, "L0", "displacement u of the material from where it was at the start"},
      {"green_lagrange_strain", tensor, false, true, "1", "E = (F^T F - I) / 2 with F = I + Grad u"},
      {"first_piola_stress", tensor, false, true, "a b^2",
       "first Piola-Kirchhoff stress that acts, of elasticity as it is integrated, fibres, viscosity and branches: "
       "force per reference area, row i is its direction"},
      {"cauchy_stress", tensor, false, true, "a b^2",
       "sigma = P F^T / J of the first_piola_stress that acts, with viscosity and branches: force per deformed area; "
       "with small strains it is the same as P"},
      {"volume_ratio", scalar, false, true, "1", "J = det F: deformed over reference volume"},
  };
  return table;
}

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const FieldInfo& field : field_table()) names.push_back(field.name);
  return names;
}

const FieldInfo& field_info(const std::string& name) {
  return *std::find_if(field_table().begin(), field_table().end(),
                       [&](const FieldInfo& field) { return field.name == name; });
}

}  // namespace softwet
