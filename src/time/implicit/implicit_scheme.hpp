// Generalized-alpha with Newton's method: a scheme without a largest step.
#pragma once

#include "time/implicit/implicit_solver.hpp"
#include "time/step/scheme.hpp"

namespace softwet {

/// Predicts, solves the nonlinear system of the step, and judges what it found.
template <int D, int P>
class ImplicitScheme final : public Scheme<D, P> {
 public:
  ImplicitScheme(const Scene<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { solver_.integrator.initialise(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state, const Array& before) override {
    Kokkos::deep_copy(Exec(), before, state.unknown);
    solver_.integrator.finish(solver_.x, state);
  }
  void refuse(const Refusal& why) override {
    if (!why.empty()) solver_.newton.forget_preconditioner();
  }
  void visit_memory(StepMemory&, const State&) override;
  std::string memory_format() const override;
  SolverCounts& counts() override { return solver_.newton.counts(); }
  const Preconditioner* preconditioner() const override { return &solver_.newton.preconditioner(); }

  GeneralizedAlpha<D, P>& integrator() { return solver_.integrator; }

 private:
  void predict(const StepHistory&, double dt);

  ImplicitSolver<D, P> solver_;
};

}  // namespace softwet
