// One accepted time step: predict, solve, judge, accept or halve.
#pragma once

#include "solver/newton.hpp"
#include "time/generalized_alpha.hpp"
#include "time/step_control.hpp"

namespace softwet {

struct StepReport {
  double dt = 0;
  int newton = 0, krylov = 0;
  double indicator = 0;
};

/// Counts of the whole run.
struct StepCounts {
  long steps = 0, rejected_newton = 0, rejected_error = 0;
  std::string last_rejection;
};

template <int D, int P>
class Stepper {
 public:
  Stepper(const Model<D, P>& model, const Case& c, std::vector<double> events);

  /// Takes over a state without history. The first step is predicted to change nothing.
  void start(const State& state);

  /// Advances by one accepted step. Throws Error (computation_failed) when no step is small enough; the state is then
  /// still the last good one.
  StepReport step();

  const State& state() const { return state_; }
  State& state() { return state_; }
  Array previous() const { return previous_; }
  double previous_dt() const { return previous_dt_; }
  void restore(const State& state, const Array& previous, double previous_dt, double proposed);

  GeneralizedAlpha<D, P>& integrator() { return integrator_; }
  StepControl& control() { return control_; }
  Newton& newton() { return newton_; }
  StepCounts& counts() { return counts_; }

 private:
  void predict(double dt);
  NewtonResult solve(double dt);
  double indicator(double dt) const;
  /// Why an iterate of Newton's method, or the step that it makes, is not admissible; empty when it is.
  std::string complaint(const Array& x) const;
  std::string complaint_of_step() const;
  std::vector<FieldRange> fields() const;

  const Model<D, P>& model_;
  GeneralizedAlpha<D, P> integrator_;
  Newton newton_;
  NewtonControl newton_control_;
  double undershoot_;
  StepControl control_;
  State state_;
  Array previous_, predicted_, x_;
  double previous_dt_ = 0;
  double volume_norm_ = 1;
  double length_ = 1;  ///< the thinner of solid layer and fluid: what displacement errors are compared with
  StepCounts counts_;
};

}  // namespace softwet
