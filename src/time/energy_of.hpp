// The energy of a state of a scene, and its powers.
#pragma once

#include "model/model.hpp"
#include "time/energy_balance.hpp"

namespace softwet {

/// @param load_power  of the loads on the state's velocities
/// @param sum         the integrals of the state
inline EnergyState energy_of(double time, double load_power, const Integrals& sum) {
  EnergyState e;
  e.time = time;
  e.energy = sum.energy();
  e.size = sum.size();
  e.kinetic = sum["energy_kinetic"];
  e.fed = load_power + sum["wall_stretch"];
  e.lost = sum.dissipation();
  return e;
}

}  // namespace softwet
