// From physical numbers to those of a case: the scales a, b, L0 of Bueno et al. 2017, eqs. (8)-(13) (host).
#pragma once

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

/// fluid.capillarity of the scene: as asked for, as a number or as a length, else a tenth of the radius over L0.
double capillarity_of(const PhysicalScene&);

/// The contact angle in degrees: as asked for, else by Young's law from the tensions of the solid, else 90.
double contact_angle_of(const PhysicalScene&);

Scales scales_of(const PhysicalScene&);

/// Fluid, solid and droplet of a case with these numbers; its domain is left empty.
Case case_of(const PhysicalScene&, const Scales&);

/// Fluid, solid and droplet of a table [laboratory], which may lack quantities: numbers that follow from them are
/// without meaning.
Case case_of_laboratory(const PhysicalScene&);

}  // namespace softwet
