// The energy of a state of a scene, and its powers.
#pragma once

#include "observe/host/energy_balance.hpp"
#include "scene/integrals.hpp"

namespace softwet {

/// Springs of needles count as forces from outside, without their energy: a needle that jumps does no work on the solid
/// in no time.
/// @param load_power  of the loads, and of such springs, on the state's velocities
/// @param sum         the integrals of the state
inline EnergyState energy_of(double time, double load_power, const Integrals& sum) {
  EnergyState e;
  e.time = time;
  e.energy = sum.energy() - sum["energy_needle"];
  e.size = sum.size();
  e.kinetic = sum["energy_kinetic"];
  e.fed = load_power + sum["wall_stretch"];
  e.lost = sum.dissipation();
  return e;
}

}  // namespace softwet
