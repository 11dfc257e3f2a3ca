// The axes of a scene's patch.
#pragma once

#include "case/mesh.hpp"
#include "spline/axis.hpp"

namespace softwet {

/// Axis d, with the kink between solid and fluid on the vertical one.
inline Axis axis_of(const Case& c, int d, int degree) {
  const bool periodic = c.boundary.side[d][0] == Side::periodic;
  const bool has_wall = d == c.dimension() - 1 && c.substrate && c.fluid;
  const int kink = has_wall ? solid_elements(c) : 0;
  const std::vector<double> breaks = graded_breaks(c, d);
  if (!breaks.empty()) return {breaks, degree, periodic, kink};
  return {c.domain.size[d], c.domain.elements[d], degree, periodic, kink};
}

}  // namespace softwet
