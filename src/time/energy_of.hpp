// The energy of a state of a scene, and its powers.
#pragma once

#include <cmath>

#include "model/model.hpp"
#include "time/energy_balance.hpp"

namespace softwet {

/// @param load_power  of the loads on the state's velocities
/// @param sum         the integrals of the state
inline EnergyState energy_of(double time, double load_power, const Integrals& sum) {
  EnergyState e;
  e.time = time;
  e.energy = sum.energy();
  for (double part : {sum.energy_kinetic, sum.energy_bulk, sum.energy_gradient, sum.energy_wall, sum.energy_elastic,
                      sum.energy_gravity})
    e.size += std::abs(part);
  e.kinetic = sum.energy_kinetic;
  e.fed = load_power + sum.wall_stretch;
  e.lost = sum.dissipation();
  return e;
}

}  // namespace softwet
