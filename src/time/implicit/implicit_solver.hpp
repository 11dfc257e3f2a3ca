// What all implicit steps share: the integrator, Newton's method, and their settings from a case.
#pragma once

#include "time/implicit/generalized_alpha.hpp"
#include "time/implicit/newton.hpp"
#include "time/step/judge.hpp"

namespace softwet {

/// The solid at a stage. A velocity v with waves as short as two elements meets inertia rho a and stiffness
/// (lambda + 2 mu) k^2 u, where a = rate_scale v, u = displacement_scale v and k = 2 / h. So its part of the Jacobian
/// falls with the time step while that is short, and grows with it later.
template <int D, int P>
SolidPart solid_part(const Scene<D, P>&, const Stage&);

template <int D, int P>
struct ImplicitSolver {
  ImplicitSolver(const Scene<D, P>&, const Case&, const Judge<D, P>&);

  /// The nonlinear system of the step that the integrator has begun.
  NonlinearSystem system();
  /// The fields of the residual, with the floors of their norms.
  std::vector<FieldRange> fields() const;
  /// How far a correction of the unknowns would move the solid, over what is accepted.
  /// @param stretch  the unknowns hold the velocities of the solid so many times
  double remaining(const Array& at, const Array& correction, double stretch = 1) const;
  /// Solves a system from `x` on, and judges what it found. The indicator is not set.
  StepAttempt solve(const NonlinearSystem&, const std::vector<FieldRange>&);

  const Scene<D, P>& scene;
  const Judge<D, P>& judge;
  GeneralizedAlpha<D, P> integrator;
  Newton newton;
  bool judges_solid;  ///< what `remaining` says counts: there is a solid, and a preconditioner for it
  NewtonControl control;
  double volume_norm;  ///< the norm of a vector of residuals that are 1 per volume
  Array x;             ///< the unknowns of the stage
};

}  // namespace softwet
