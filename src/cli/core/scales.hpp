// From physical numbers to those of a case: the scales a, b, L0 of Bueno et al. 2017, eqs. (8)-(13) (host).
#pragma once

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

/// What 1 means in a case, in SI units.
struct Scales {
  double length;   ///< L0, m
  double density;  ///< b, kg/m^3:            rho_l = rho_hat_l(theta) b
  double a;        ///< Pa (m^3/kg)^2:        sigma = sigma_hat(theta, gamma) a b^2 L0

  double velocity() const;                                            ///< sqrt(a b), m/s
  double time() const { return length / velocity(); }                 ///< s
  double stress() const { return a * density * density; }             ///< a b^2, Pa
  double viscosity() const { return length * density * velocity(); }  ///< L0 b sqrt(a b), Pa s
};

/// fluid.capillarity of the scene: as asked for, else a tenth of the radius over L0.
double capillarity_of(const PhysicalScene&);

Scales scales_of(const PhysicalScene&);

/// Fluid, solid and droplet of a case with these numbers; its domain is left empty.
Case case_of(const PhysicalScene&, const Scales&);

}  // namespace softwet
