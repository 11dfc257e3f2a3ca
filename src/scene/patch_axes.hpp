// The axes of a scene's patch.
#pragma once

#include "case/mesh.hpp"
#include "spline/axis.hpp"

namespace softwet {

/// Axis d, radial where it is r of (r, z), with the kink between solid and fluid and the joint of the solid on the
/// vertical one.
inline Axis axis_of(const Case& c, int d, int degree) {
  const bool periodic = c.boundary.side[d][0] == Side::periodic;
  const AxisKind kind = c.axisymmetric() && d == 0 ? AxisKind::radial
                        : periodic                 ? AxisKind::periodic
                                                   : AxisKind::bounded;
  const bool has_solid = d == c.dimension() - 1 && c.substrate;
  const int kink = has_solid && c.fluid ? solid_elements(c) : 0, joint = has_solid ? joint_element(c) : 0;
  const std::vector<double> breaks = graded_breaks(c, d);
  if (!breaks.empty()) return {breaks, degree, kind, kink, joint};
  return {c.domain.size[d], c.domain.elements[d], degree, kind, kink, joint};
}

}  // namespace softwet
