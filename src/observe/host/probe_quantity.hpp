// The scalars that a probe can look at: fields of the field table, and components of them.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "observe/host/field_table.hpp"

namespace softwet {

/// A scalar of a field.
struct ProbeQuantity {
  const FieldInfo* field = nullptr;
  int component = 0;       ///< among the components of the field, as the field files have them; of a tensor 3 i + j
  bool magnitude = false;  ///< the length of the vector
  int dimension = 0;       ///< 3: it exists in 3D only
};

/// "density", "velocity_x", "speed", "cauchy_stress_xy"; of a symmetric tensor the upper half.
std::vector<std::string> probe_quantities();

/// The quantity of that name, which is one of the names.
ProbeQuantity probe_quantity(const std::string& name);

/// Whether a probe of the case looks at a velocity, or at a stress that depends on one or on branches: not every
/// snapshot holds them.
bool probes_need_velocity(const Case&);

}  // namespace softwet
