// The equations of the fluid from the numbers of a case.
#pragma once

#include "case/case.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "scene/equilibrium.hpp"

namespace softwet {

/// @param flat      densities of the two phases
/// @param shortest  side of an element, which the stabilisation follows
inline NavierStokesKorteweg fluid_of(const Fluid& f, const Coexistence& flat, double shortest) {
  NavierStokesKorteweg fluid;
  fluid.gas = {f.temperature, 0.2 * flat.density_vapour};
  fluid.viscosity = f.viscosity;
  fluid.capillarity = f.capillarity;
  fluid.stabilisation = f.stabilisation * shortest * shortest / f.viscosity;
  fluid.inertia_floor = 0.1 * flat.density_vapour;
  for (std::size_t d = 0; d < f.gravity.size(); ++d) fluid.force[d] = f.gravity[d];
  return fluid;
}

}  // namespace softwet
