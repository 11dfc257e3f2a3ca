#include "observe/host/probe_quantity.hpp"

#include <algorithm>
#include <utility>

#include "case/gel.hpp"

namespace softwet {
namespace {

using Named = std::pair<std::string, ProbeQuantity>;

void add_vector(const FieldInfo& field, std::vector<Named>& all) {
  for (int d = 0; d < 3; ++d) all.push_back({field.name + "_" + "xyz" [d], { &field, d, false, d == 2 ? 3 : 0 }});
  if (field.name == "velocity") all.push_back({"speed", {&field, 0, true}});
}

void add_tensor(const FieldInfo& field, std::vector<Named>& all) {
  const bool symmetric = field.name != "first_piola_stress";
  for (int i = 0; i < 3; ++i)
    for (int j = symmetric ? i : 0; j < 3; ++j)
      all.push_back(
          {field.name + "_" + "xyz"[i] + "xyz" [j], { &field, 3 * i + j, false, i != j&& i + j > 1 ? 3 : 0 }});
}

const std::vector<Named>& quantities() {
  static const std::vector<Named> table = [] {
    std::vector<Named> all;
    for (const FieldInfo& field : field_table()) {
      if (field.shape == FieldShape::scalar) all.push_back({field.name, {&field}});
      if (field.shape == FieldShape::vector) add_vector(field, all);
      if (field.shape == FieldShape::tensor) add_tensor(field, all);
    }
    return all;
  }();
  return table;
}

}  // namespace

std::vector<std::string> probe_quantities() {
  std::vector<std::string> names;
  for (const Named& named : quantities()) names.push_back(named.first);
  return names;
}

ProbeQuantity probe_quantity(const std::string& name) {
  for (const auto& [known, quantity] : quantities())
    if (known == name) return quantity;
  return {};
}

bool probes_need_velocity(const Case& c) {
  const bool rates = c.substrate && (shear_viscosity(*c.substrate) > 0 || c.substrate->bulk_viscosity > 0 ||
                                     c.substrate->has_branches());
  return std::any_of(c.probes.begin(), c.probes.end(), [&](const Probe& probe) {
    const std::string& field = probe_quantity(probe.quantity).field->name;
    return field == "velocity" || (rates && (field == "cauchy_stress" || field == "first_piola_stress"));
  });
}

}  // namespace softwet
