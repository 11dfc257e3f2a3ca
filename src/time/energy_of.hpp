// The energy of a state of a scene, and its powers.
#pragma once

#include <cmath>

#include "model/model.hpp"
#include "time/energy_balance.hpp"

namespace softwet {

/// @param sum  the integrals of the state
template <int D, int P>
EnergyState energy_of(const Model<D, P>& model, double time, const ConstArray& unknown, const Integrals& sum) {
  EnergyState e;
  e.time = time;
  e.energy = sum.energy();
  for (double part : {sum.energy_kinetic, sum.energy_bulk, sum.energy_gradient, sum.energy_wall, sum.energy_elastic,
                      sum.energy_gravity})
    e.size += std::abs(part);
  e.kinetic = sum.energy_kinetic;
  e.fed = model.load_power(time, unknown) + sum.wall_stretch;
  e.lost = sum.dissipation();
  return e;
}

}  // namespace softwet
