// Integrals of the state, for history.csv.
#pragma once

#include <array>
#include <cmath>

#include "kernels/point/fields.hpp"

namespace softwet {

/// Scales: energies a b^2 L0^D, mass b L0^D; in the coordinates (r, z) those of space, L0^3.
struct Integrals {
  double mass = 0, energy_kinetic = 0, energy_bulk = 0, energy_gradient = 0, energy_wall = 0, energy_elastic = 0;
  double energy_surface = 0, energy_gravity = 0;
  double momentum[3] = {0, 0, 0};
  double viscous = 0, stabilisation = 0, solid_viscous = 0;  ///< dissipation rates
  double wall_stretch =
      0;  ///< int_Gamma f_w div_Gamma vh: power of the wall energy on a stretching wall, where it feeds the system

  double& part(EnergyPart p) { return p == EnergyPart::surface ? energy_surface : energy_elastic; }
  std::array<double, 7> energies() const {
    return {energy_kinetic, energy_bulk, energy_gradient, energy_wall, energy_elastic, energy_surface, energy_gravity};
  }
  double energy() const {
    double sum = 0;
    for (double part : energies()) sum += part;
    return sum;
  }
  /// Sum of the sizes of the parts, of which the round-off of the energy is a part.
  double size() const {
    double sum = 0;
    for (double part : energies()) sum += std::abs(part);
    return sum;
  }
  /// From those for each radian about an axis to those of a whole turn. Of the momentum what points away from the axis cancels.
  void turn(double angle) {
    for (double* part :
         {&mass, &energy_kinetic, &energy_bulk, &energy_gradient, &energy_wall, &energy_elastic, &energy_surface,
          &energy_gravity, &momentum[1], &viscous, &stabilisation, &solid_viscous, &wall_stretch})
      *part *= angle;
    momentum[0] = 0;
  }
  double dissipation() const { return viscous + stabilisation + solid_viscous; }
};

}  // namespace softwet
