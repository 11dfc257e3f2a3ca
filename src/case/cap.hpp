// The circle of a droplet or bubble that sits on the wall.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "case/case.hpp"

namespace softwet {

/// Cosine of the angle inside a cap: alpha in a droplet, 180 degrees - alpha in a bubble, for alpha is measured in the
/// liquid. The circle's centre lies -R cos above the wall, its top R (1 - cos). Where the angle varies, the angle of
/// the wall at the droplet's centre counts; where the wall is stretched before, the effective angle.
inline double cap_cosine(const Case& c, const Droplet& droplet) {
  const Fluid& fluid = *c.fluid;
  std::array<double, 3> x{};
  std::copy_n(droplet.centre.begin(), std::min<std::size_t>(3, droplet.centre.size()), x.begin());
  const double cosine = c.cosine_factor() * std::cos(fluid.contact_angle.at(x) * 3.14159265358979323846 / 180);
  return fluid.ambient == Phase::liquid ? -cosine : cosine;
}

/// Whether a droplet is centred on the wall, where it becomes a cap.
inline bool sits_on_wall(const Case& c, const Droplet& droplet) {
  const double wall = c.wall_height();
  return std::abs(droplet.centre.back() - wall) <= 1e-9 * c.domain.size.back();
}

}  // namespace softwet
