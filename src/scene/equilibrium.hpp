// Equilibrium of liquid and vapour: coexistence, surface tension, and densities of a curved interface (host).
#pragma once

#include "kernels/fluid/contact_angle.hpp"

namespace softwet {

struct Fluid;

/// Densities of the two phases at equal pressure and chemical potential. Errors: theta outside (0, 1).
/// Tested against independent values: tests/unit/scene/test_equilibrium.cpp
Coexistence coexistence(double temperature);

struct PhaseDensities {
  double vapour, liquid;
};

/// Densities at which W'' = 0, the ends of the two phases: rho (1 - rho)^2 = 4 theta / 27.
PhaseDensities spinodal(double temperature);

/// Densities of the two phases at a chemical potential between the spinodal values.
PhaseDensities densities_at(double temperature, double potential);

/// Surface tension sigma = g int_{rho_v}^{rho_l} sqrt(2 D(rho)) d rho, scale a b^2 L0.
double surface_tension(const Fluid& fluid);

/// Mean slope of the planar interface, weighted by its share of the surface tension: int 2 D d rho / (g int sqrt(2 D) d
/// rho), scale b/L0.
double mean_interface_slope(const Fluid& fluid);

/// Half width w of tanh(x / w) with the slope of the planar interface in its middle; scale L0.
double interface_half_width(const Fluid& fluid);

}  // namespace softwet
