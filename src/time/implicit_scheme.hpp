// Generalized-alpha with Newton's method: a scheme without a largest step.
#pragma once

#include "time/generalized_alpha.hpp"
#include "time/judge.hpp"

namespace softwet {

/// The solid at a stage. A velocity v with waves as short as two elements meets inertia rho a and stiffness
/// (lambda + 2 mu) k^2 u, where a = rate_scale v, u = displacement_scale v and k = 2 / h. So its part of the Jacobian
/// falls with the time step while that is short, and grows with it later.
template <int D, int P>
SolidPart solid_part(const Model<D, P>&, const Stage&);

/// A step towards rest, and how far its beginning was from it.
struct Settling {
  StepAttempt step;
  /// Of the residual at the start over what the last digit of the fields makes of it, the largest of all fields.
  double excess = 0;
};

/// Predicts, solves the nonlinear system of the step, and judges what it found.
template <int D, int P>
class ImplicitScheme final : public Scheme<D, P> {
 public:
  ImplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { integrator_.initialise(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  /// A step of backward Euler of any length, in which loads stand still at the time of the state. Takes no iteration
  /// where nothing is left to solve: where `excess` is below `digits_of_rest`. The indicator is not set.
  /// The equations of an endless step are singular: the total mass is left open. Those of a long step nearly are, and
  /// the velocities of the solid have the size of its displacement over the step. So Newton's method sees them as a
  /// step of moderate length, T, stretched s = dt / T times: its unknown is s v in the solid, the sum of the rows of
  /// the mass counts s times, which the solution does not notice, and the preconditioner is that of the step T.
  Settling settle(const State&, double dt);
  /// The answer of a state at rest to a small disturbance: x with A x = -r, to seven digits. A is the Jacobian of a step dt of
  /// backward Euler from there, in which loads stand still.
  NewtonResult respond(const State& rest, double dt, const Array& r, const Array& x);
  void accept(State& state) override { integrator_.finish(x_, state); }
  void refuse(const Refusal& why) override {
    if (!why.empty()) newton_.forget_preconditioner();
  }
  void visit_memory(StepMemory&, const State&) override;
  SolverCounts& counts() override { return newton_.counts(); }
  const Preconditioner* preconditioner() const override { return &newton_.preconditioner(); }

  GeneralizedAlpha<D, P>& integrator() { return integrator_; }

 private:
  NonlinearSystem system();
  /// Adds to the residual of a stretched step, or to a product, what makes the total mass count as in one that is not.
  void tie_mass(const Array& r) const;
  /// The unknowns with the velocities of the solid, which Newton's method sees multiplied with the stretch.
  Array unstretched(const Array& x) const;
  void product(const Array& z, const Array& out);
  void product(const ArrayOf<float>& z, const ArrayOf<float>& out);
  void predict(const StepHistory&, double dt);
  NewtonResult solve(const StepHistory&, double dt);
  std::vector<FieldRange> fields() const;
  /// The round-off of residuals in single precision, as it is at the prediction.
  void measure_round_off(std::vector<FieldRange>&);

  const Model<D, P>& model_;
  const Judge<D, P>& judge_;
  GeneralizedAlpha<D, P> integrator_;
  Newton newton_;
  NewtonControl newton_control_;
  double volume_norm_;  ///< the norm of a vector of residuals that are 1 per volume
  double stretch_ = 1;  ///< of this step: how many times it is as long as one that is not nearly singular
  Array unstretched_;
  Array wide_, product_;  ///< a direction in double precision, and its product; empty but in settling steps
  Array x_;
  Array round_off_;  ///< empty but in single precision
};

}  // namespace softwet
