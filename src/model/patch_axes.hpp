// The axes of a scene's patch.
#pragma once

#include <cmath>

#include "case/case.hpp"
#include "spline/axis.hpp"

namespace softwet {

/// Rows of elements in the solid; 0 without a solid.
inline int solid_elements_of(const Case& c) {
  const double spacing = c.domain.size.back() / c.domain.elements.back();
  return c.substrate ? static_cast<int>(std::lround(c.substrate->thickness / spacing)) : 0;
}

/// Axis d, with the kink between solid and fluid on the vertical one.
inline Axis axis_of(const Case& c, int d, int degree) {
  const bool periodic = c.boundary.side[d][0] == Side::periodic;
  const bool has_wall = d == c.dimension() - 1 && c.substrate && c.fluid;
  return {c.domain.size[d], c.domain.elements[d], degree, periodic, has_wall ? solid_elements_of(c) : 0};
}

}  // namespace softwet
