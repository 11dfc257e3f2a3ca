// Runge-Kutta schemes on a scene: largest stable step, states and moments.
#pragma once

#include "time/judge.hpp"
#include "time/linearised.hpp"
#include "time/power_iteration.hpp"
#include "time/semi_discrete.hpp"
#include "time/stability_limit.hpp"
#include "time/stiff_radius.hpp"

namespace softwet {

/// The largest stable step of the scheme for the linearised rates limits the step. It is searched for on differences of
/// rates, kept for a number of steps, and searched for anew after a refused step. That number depends on the steps of the
/// search, so searches take half of a run at most, and a tenth where the limit stays the same.
template <int D, int P>
class ExplicitScheme final : public Scheme<D, P> {
 public:
  ExplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { system_.set_moments(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state) override;
  void refuse() override {
    known_rates_ = false;
    if (age_ == 0) return;
    age_ = most_age_;
    stability_.forget();
  }
  double largest_step(const State&) override;
  void visit_memory(StepMemory&, const State&) override;
  SolverCounts& counts() override { return counts_; }

 private:
  Refusal rates(double t, const Array& y, const Array& out);
  /// Fills y and its rates from a state, unless they are those of the last accepted step.
  Refusal begin(const State&);
  void measure_limit(double t);
  /// Without a limit from before: the spectral radius tells about where it is. 0: there is no radius
  double limit_from_radius(double t);
  void measure_stiff_part();

  const Judge<D, P>& judge_;
  SemiDiscrete<D, P> system_;
  std::unique_ptr<RungeKutta> scheme_;
  Linearised linear_;
  PowerIteration spectrum_;     ///< of the rates that limit the step
  StiffRadius stiff_spectrum_;  ///< where the scheme needs it
  StabilityLimit stability_;
  double safety_, limit_ = 0;
  Array y_, rates_, next_, next_rates_;
  double end_ = 0;
  bool known_rates_ = false;
  int age_ = 0, most_age_ = 0;  ///< of the limit, in steps
  SolverCounts counts_;
};

}  // namespace softwet
