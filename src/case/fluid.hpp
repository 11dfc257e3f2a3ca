// The liquid and its vapour, and their wall.
#pragma once

#include <cmath>
#include <vector>

#include "case/choices.hpp"
#include "case/profile.hpp"

namespace softwet {

struct Fluid {
  double viscosity = 0;        ///< mu_hat, eq. (9)
  double capillarity = 0;      ///< gamma_hat, eq. (8)
  double temperature = 0;      ///< theta_hat, eq. (10)
  Profile contact_angle = 90;  ///< degrees, measured in the liquid, at the points of the wall
  WallLaw wall_law = WallLaw::gradient;
  WallTensionModel wall_tension = WallTensionModel::none;
  double wall_stretch_exponent =
      0;  ///< beta: the wall has the energy a^(1 - beta) f_w for each area before any stretch
  Traction traction = Traction::layer;
  std::vector<double> gravity;    ///< force per unit mass on the fluid, scale a b/L0; empty: none
  double stabilisation = 0.002;   ///< C of eps = C h^2 rho^2 / mu_hat; 0 switches the checkerboard control off
  double smoothing = 1e-4;        ///< d of sqrt(|grad rho|^2 + d^2) in the wall law "gradient"
  Phase ambient = Phase::vapour;  ///< what is around the droplets; liquid makes them bubbles
  std::vector<double> initial;    ///< densities of vapour and liquid at the start; empty: equilibrium densities

  std::vector<double> contact_angle_range = {};  ///< receding and advancing angle, degrees; empty: no hysteresis
  double line_friction = 0;                      ///< mu_f, scale L0 b sqrt(ab)
  double creep_speed = 1e-4;                     ///< below which a line with hysteresis counts as at rest

  /// Half of cos(receding) - cos(advancing).
  double hysteresis() const {
    if (contact_angle_range.size() != 2) return 0;
    return 0.5 * (std::cos(contact_angle_range[0] * M_PI / 180) - std::cos(contact_angle_range[1] * M_PI / 180));
  }
  /// The angle whose cosine is the mean of the cosines of the range, degrees.
  double middle_of_range() const {
    return std::acos(std::cos(contact_angle_range[0] * M_PI / 180) - hysteresis()) * 180 / M_PI;
  }
  /// Whether a contact line loses energy as it moves, beside what the viscosity takes.
  bool resists_lines() const { return line_friction > 0 || !contact_angle_range.empty(); }
};

}  // namespace softwet
