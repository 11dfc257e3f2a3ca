// The largest stable step of explicit schemes, from a bound at every control point of a state.
#pragma once

#include <array>

#include "scene/coefficients.hpp"
#include "time/masses/mass_symbols.hpp"
#include "time/step/host_numbers.hpp"

namespace softwet {

/// What limits a step: rates of the stiffest waves of each mechanism, 1/time.
struct StepRates {
  double combined = 0;  ///< of the scheme: its step is stable up to 1 / combined
  double sound = 0, capillarity = 0, viscosity = 0, stabilisation = 0, flow = 0, elasticity = 0;
};

/// A mechanism and the shortest time that it alone leaves to a step of kick_drift, as a rate.
struct LoneRate {
  const char* name;
  double rate;
};
inline std::array<LoneRate, 6> lone_rates(const StepRates& r) {
  return {{{"sound", 0.5 * r.sound},
           {"capillary waves", 0.5 * r.capillarity},
           {"viscosity", r.viscosity},
           {"stabilisation", 0.5 * r.stabilisation},
           {"flow", 0.5 * r.flow},
           {"elasticity", 0.5 * r.elasticity}}};
}

/// Ranges of the values of a state.
struct ValueRanges {
  bool finite = true;
  double least_density = 0, most_density = 0;  ///< infinite where one is not finite
};

/// A state as a bound sees it.
struct BoundState {
  ConstArray unknown, displacement;  ///< velocities and density, with their ghosts
  ConstArray moments, sums;          ///< of the density, and row sums of the scalar mass
};

/// How a scheme combines the rates at a point: w of waves, s of viscosity, e of the stabilisation, u of the flow.
/// kick_drift: max((sqrt(e^2 + 4 (w + u)^2) + e + s) / 4, s). Without viscosity one wave is stable up to
///   (w dt)^2 + 2 e dt = 4, which is this; viscosity alone is stable up to s dt = 1; with all three it is a bound (the
///   roots of the step were tested on a grid);
/// runge_kutta: the ellipse with half axes 1.73 and 2.51 in the region of stability of three stages and third order,
///   sqrt(((w + u) / 1.73)^2 + ((s + e) / 2.51)^2);
/// without_viscosity: runge_kutta with s = 0.
enum class StepFormula { kick_drift, without_viscosity, runge_kutta };

/// At a control point with density rho and moments p over row sums a, on elements of the shortest length h:
///   w = sqrt(A^2 c^2 + C^2 g^2 rho / h^2) / h,  c^2 = max(rho W'', 0)
///   s = V (4/3) m / (p / a) / h^2,   e = eps k (c^2 / rho + g^2 k),  k = F / h^2,   u = U |v - vh| / h
/// with the symbols A, C, V, F, U (E, B, T) of the masses: the symbols of ends in the elements at an end and everywhere
/// in the solid, which also has the symbols of its joint. Where the mesh moves, h shrinks with the smallest stretch of
/// the mesh above the wall there. In the solid w = E sqrt(K / rho_0) / h with K the largest row of dP/dF of its
/// material along an axis and the largest eigenvalue of dP/dF of its fibres, together. Where two free sides meet, waves
/// along both axes join through Poisson's effect, and half of the row along the other axis is added, which is at least
/// what blocks and beams have, at Poisson ratios up to 0.49. Viscosity of the solid: s = E^2 (4/3 eta + zeta) / rho_0 /
/// h^2; on its top face w^2 has B^2 (D - 1) Ups / rho_0 / h^3 more, where the modulus lambda_s + 2 G_s counts like a
/// tension Ups, times the factor by which the stretch of the face stiffens it; on its bottom w^2 has T^2 kap / rho_0 /
/// h more by the springs of the bottom, and s has T^2 c / rho_0 / h more by its dashpots; K has 2 sum G_i more by
/// branches, times |F|^4 under finite strains; with needles of the stiffness k it has X k / rho_0 more, X = 1 with
/// lumped masses (`held` of the symbols). Control values bound the fields, which are their means, and all of these
/// rates are largest at an end of a range.
/// Tested: tests/unit/time/explicit/test_step_bound.cpp, test_step_bound_of_solids.cpp, and against a search for the
/// limit: the study stable_step
template <int D, int P>
class StepBound {
 public:
  StepBound(const Regions<D>&, const Coefficients<D>&, MassKind, StepFormula);

  // The rates and the ranges of the values of a state in two halves: starts the kernel that leaves so many numbers,
  // and, when they are on the host, gives what they are.
  static int numbers();
  void ask(const BoundState&, const HostNumbers&) const;
  static StepRates rates(const HostNumbers&);
  static ValueRanges ranges(const HostNumbers&);
  /// Computes the rates and waits for them.
  StepRates rates(const BoundState&) const;
  /// Where the combined rate is largest, in the undeformed domain.
  std::array<double, D> place_of_largest(const BoundState&) const;

 private:
  /// Calls visit(points of the fluid, points of the solid). On the host the stretches of columns were found before.
  template <class Visit>
  void visit_points(const BoundState&, const Visit& visit) const;
  /// The point of the solid at which rates are computed. @tparam Axial  in the coordinates (r, z), where waves have a
  /// hoop strain too
  template <bool Axial, class Solid>
  auto solid_point(const Solid&, const ConstArray& displacement) const;

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  StepFormula formula_;
  MassSymbols inside_, end_;
  bool adds_axes_;
  bool free_axis_[D] = {};  ///< a solid alone that has a free end along the axis
  double length_;           ///< of the shortest side of an element
  ConstArray greville_[D];  ///< of stored columns
  ConstArray blend_;        ///< of the rows of the fluid
  ConstArray near_end_;     ///< 1 for the control points of the fluid near an end, else 0
  Array stretch_;           ///< 1 / smallest stretch of the mesh, by column
  HostNumbers found_;
};

}  // namespace softwet
