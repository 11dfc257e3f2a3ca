// Dimensionless groups and time scales of a scene: what decides how it behaves (host).
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// The liquid of a droplet and its radius, in one system of units.
struct Liquid {
  double density, viscosity, tension, radius;

  /// Ohnesorge number mu / sqrt(rho_l sigma R): viscosity over inertia and capillarity. Below 1 a droplet oscillates.
  double ohnesorge() const;
  /// Capillary number mu v / sigma of a speed v: viscosity over capillarity.
  double capillary_number(double speed) const { return viscosity * speed / tension; }
  /// Reynolds number rho_l v R / mu of a speed v: inertia over viscosity.
  double reynolds(double speed) const { return density * speed * radius / viscosity; }

  double time_capillary() const {
    return viscosity * radius / tension;
  }                             ///< capillarity against viscosity, mu R / sigma
  double time_inertia() const;  ///< the same against inertia, sqrt(rho_l R^3 / sigma)
  double time_viscosity() const { return density * radius * radius / viscosity; }  ///< vorticity crosses the droplet
};

/// The liquid of the largest droplet. Only with a fluid and a droplet.
Liquid liquid_of(const Case&);

/// Largest radius of the droplets; 0 without.
double largest_radius(const Case&);

/// sigma / E, the length over which capillary forces deform the solid; scale L0. 0 without a fluid or a solid.
double elastocapillary_length(const Case&);

/// Time in which a shear wave crosses the layer, Hs / sqrt(G / rho_0^s); scale L0/sqrt(ab). Only with a solid.
double time_elasticity(const Substrate&);

/// Ripple of the speed of a droplet that is driven along the wall, over it, root of the mean square: it meets each
/// element alike.
///   1.3 % (2 h / gamma)^4     h: length of an element along x, the short ones where they are graded
/// 0 where nothing drives a droplet, and where it was not measured: in 3D, with degree 3.
/// Measured for h / gamma from 1/3 to 1: docs/verification/speed_ripple.md. It is within 30 % on a soft layer from two
/// elements to the capillarity on, and too large on a rigid wall; with one element a droplet lurches from element to
/// element.
double speed_ripple(const Case&);

struct Group {
  std::string name;  ///< key of run.json, "elastocapillary_over_radius"
  double value;
  std::string meaning;
};

/// The groups and time scales of a scene: some need a droplet, some a solid. A speed of 1 in history.csv is sqrt(ab).
/// Tested by hand-worked numbers: tests/unit/scene/test_groups.cpp
std::vector<Group> groups(const Case&);

}  // namespace softwet
