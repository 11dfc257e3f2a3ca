// Problems of a scene that are known before it is computed (host).
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Radius below which a droplet or bubble dissolves; scale L0. The larger of two:
///   1.75 w                 w: half width of the interface; there is no room for liquid between its flanks
///   R_c + w / 2            R_c: a smaller sharp droplet feeds the vapour of the closed box faster than its vapour
///                          pressure rises,  R_c^(D+1) = (D - 1) sigma V / (W''(rho_around) (rho_l - rho_v)^2 k),
///                          V the volume of the fluid, k = (dV_droplet/dR) / R^(D-1)
/// Runs of single droplets against it: docs/limits.md.
double least_radius(const Case&, const Droplet&);

/// Longest sigma / E that a Saint Venant-Kirchhoff solid bears under a droplet; scale L0: 0.85 capillarities or 0.17
/// radii of the largest droplet, whichever is longer, times 1 + Upsilon / (2 sigma) with the surface tension Upsilon of
/// the dry solid. Measured in 2D at temperature 0.39 (docs/limits.md): in the scenes of its tables runs went through
/// below and stopped above, soon after the start; of eight scenes sampled at random five stopped at 0.85 capillarities
/// already. A layer that was compressed before has the stiffness of its face less (`stiffness_of_face`); that factor is
/// from theory, not measured. Only with a fluid and a solid.
double longest_elastocapillary_length(const Case&);

/// True where sigma / E is longer.
bool too_soft(const Case&);

/// What to write so that a soft solid bears its droplet from the start on, what helped most sampled scenes first: the
/// material where the solid has a tension, viscosity, the tension of the solid, a start at rest. A state of rest knows
/// no viscosity. Measured: docs/limits.md.
std::string gentle_start(const Case&);

/// Largest error of the displacement of a layer of degree 2, relative, under a smooth load within it:
///   0.94 % (0.1 / (1 - 2 nu))^0.37 (2 / rows)^2, a fit to docs/verification/locking.md.
double locking_error(const Case&);

/// How much too low, relative, the ridge under a contact line is in a nearly incompressible layer: its load is as
/// narrow as the interface, and the layer locks there long before it does under smooth loads. With m = capillarity /
/// element,
///   degree 2: 1.7 exp(-6 sqrt(m (1 - 2 nu)^0.3)) sqrt(8 / rows)
///   degree 3: 0.52 exp(-5 m (1 - 2 nu)^0.15) sqrt(8 / rows)
/// fit tests/oracle/ridge_locking.py (4 to 32 rows, m from 1.5 to 4) within 40 % where it is above 1 %. 0 without a
/// droplet or film on a solid. Tested: tests/unit/foresight/test_forecast.cpp
double ridge_error(const Case&);

/// Width of fluid between two droplets, or a droplet and a side, below which they are reported as near; scale L0: four
/// half widths of the interface, 4.3 capillarities at temperature 0.39. Measured: docs/limits.md.
double least_gap(const Fluid&);

/// Sentences for the user, each with key, value, bound and remedy: droplets that dissolve or are near each other or a
/// side, a fluid without any, a solid too soft for its droplet, one whose prestretch asks for another law or folds, one
/// that locks, a density that changes its stiffness, a tolerance that costs steps. Empty when nothing is known.
std::vector<std::string> forecast(const Case&);

}  // namespace softwet
