// The constants of the advice before a run, and where each was measured.
#pragma once

namespace softwet::measured {

// Droplets that dissolve, and gaps that close: runs of single droplets, docs/limits.md.
inline constexpr double least_radius = 1.75;    ///< over the half width of an interface
inline constexpr double radius_of_flank = 0.5;  ///< of a half width, compared with the radius of a sharp droplet
inline constexpr double least_gap = 4;          ///< in half widths

// Solids too soft for their droplets: runs of static_droplet_soft_2d and sampled scenes, docs/limits.md.
inline constexpr double softness_of_interface = 0.85;  ///< sigma / E over the capillarity
inline constexpr double softness_of_droplet = 0.17;    ///< sigma / E over the radius
inline constexpr double softness_by_tension = 0.5;     ///< more of it for each Upsilon / sigma
/// Part of that length: of eight scenes sampled at random one stopped at 0.76 of it, none at 0.59.
inline constexpr double surely_held = 0.59;
/// Part of it up to which all nine sampled neo-Hookean solids with a tension bore their droplets.
inline constexpr double held_by_neo_hookean = 2.5;

// Locking under smooth loads: fit to docs/verification/locking.md.
inline constexpr double locking = 0.0094, locking_exponent = 0.37;
/// Errors that are worth a warning.
inline constexpr double error_to_tell = 0.01;

// Ridges that are too low: fit to tests/oracle/ridge_locking.py, 4 to 32 rows, 1.5 to 4 elements to a capillarity.
inline constexpr double ridge_degree_2 = 1.7, ridge_degree_2_rate = 6, ridge_degree_2_exponent = 0.3;
inline constexpr double ridge_degree_3 = 0.52, ridge_degree_3_rate = 5, ridge_degree_3_exponent = 0.15;

// Tolerances that cost steps: solver.newton.atol of cases/tensotaxis_pull_2d.toml, docs/development/solver_choices.md.
inline constexpr double loose_tolerance = 1e-5;

// Density of a solid over its liquid, or of the liquid over the solid, that no gel and no metal has: a warning says
// that it changes the stiffness.
inline constexpr double unusual_density = 25;

// Explicit steps that cost less than the implicit ones of the same scene: docs/fast_scenes.md.
inline constexpr double most_explicit_steps_2d = 1300, most_explicit_steps_3d = 2000;

}  // namespace softwet::measured
