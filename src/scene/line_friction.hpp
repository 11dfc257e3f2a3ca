// What contact lines lose as they move, from the numbers of a case.
#pragma once

#include <cmath>

#include "case/case.hpp"
#include "kernels/fluid/line_friction.hpp"
#include "scene/equilibrium.hpp"

namespace softwet {

/// The sine in B of mu_f is the sine of the static angle. A line whose density has the mean slope of the interface has
/// the rate r0 at the speed fluid.creep_speed.
inline LineFriction line_friction_of(const Fluid& fluid, EnergyWall barrier) {
  const double sine = std::sin(fluid.contact_angle.number * M_PI / 180), g = fluid.capillarity;
  barrier.cosine = fluid.hysteresis();
  return {fluid.line_friction * g * g / (surface_tension(fluid) * sine),
          fluid.creep_speed * mean_interface_slope(fluid), barrier};
}

}  // namespace softwet
