// Generalized-alpha with Newton's method: a scheme without a largest step.
#pragma once

#include "time/generalized_alpha.hpp"
#include "time/judge.hpp"

namespace softwet {

/// The solid at a stage. A velocity v with waves as short as two elements meets inertia rho a and stiffness
/// (lambda + 2 mu) k^2 u, where a = rate_scale v, u = displacement_scale v and k = 2 / h. So its part of the Jacobian falls with
/// the time step while that is short, and grows with it later.
template <int D, int P>
SolidPart solid_part(const Model<D, P>&, const Stage&);

/// Predicts, solves the nonlinear system of the step, and judges what it found.
template <int D, int P>
class ImplicitScheme final : public Scheme<D, P> {
 public:
  ImplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { integrator_.initialise(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state) override { integrator_.finish(x_, state); }
  void refuse(const Refusal& why) override {
    if (!why.empty()) newton_.forget_preconditioner();
  }
  void visit_memory(StepMemory&, const State&) override;
  SolverCounts& counts() override { return newton_.counts(); }
  const Preconditioner* preconditioner() const override { return &newton_.preconditioner(); }

  GeneralizedAlpha<D, P>& integrator() { return integrator_; }

 private:
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
  Array x_;
  Array round_off_;  ///< empty but in single precision
};

}  // namespace softwet
