// An explicit step of a scene, as the scheme that controls steps sees it.
#pragma once

#include "time/explicit/semi_discrete.hpp"
#include "time/explicit/step_bound.hpp"

namespace softwet {

/// Goes from the last accepted state to one that may be accepted. A step that is not accepted leaves no trace.
template <int D, int P>
class ExplicitStep {
 public:
  explicit ExplicitStep(SemiDiscrete<D, P>& system) : system_(system) {}
  virtual ~ExplicitStep() = default;

  virtual StepFormula formula() const = 0;
  /// Takes the accepted state, with the rates that the next step begins with. The stage of the system is that state.
  virtual Refusal begin(const State&) = 0;
  /// One step. The stage of the system is the state at its end, with its velocities.
  /// @param rates  of the state that the step begins with
  Refusal advance(double t, double dt, const StepRates& rates) {
    prepare(t, dt);
    return start(t, dt, rates);
  }
  /// The first part of a step: what the host finds for it.
  virtual void prepare([[maybe_unused]] double t, [[maybe_unused]] double dt) {}
  /// The rest of a step.
  virtual Refusal start(double t, double dt, const StepRates& rates) = 0;
  /// Whether `start` only starts kernels, with arguments that follow from the addresses of its vectors and, of loads,
  /// from which act. These kernels read what changes from step to step in memory, as the system keeps it there.
  virtual bool recordable() const { return false; }
  /// Moments of the last accepted state, and of the end of the last step.
  virtual ConstArray moments() const = 0;
  virtual ConstArray next_moments() const = 0;
  /// The end of the last step is accepted and becomes `state`, whose unknowns before go to `before`.
  virtual void accept(double t, double dt, State& state, const Array& before) = 0;
  virtual void visit_memory(StepMemory&) = 0;

 protected:
  SemiDiscrete<D, P>& system_;
};

}  // namespace softwet
