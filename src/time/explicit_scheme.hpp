// Runge-Kutta schemes on a scene: largest stable step, states and moments.
#pragma once

#include "time/judge.hpp"
#include "time/power_iteration.hpp"
#include "time/runge_kutta.hpp"
#include "time/semi_discrete.hpp"

namespace softwet {

/// The spectral radius of the linearised rates limits the step. It is measured by power iteration on differences of rates,
/// kept for a number of steps, and measured anew after a refused step.
template <int D, int P>
class ExplicitScheme final : public Scheme<D, P> {
 public:
  ExplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { system_.set_moments(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state) override;
  void refuse() override { known_rates_ = false, age_ = most_age_; }
  double largest_step(const State&) override;
  SolverCounts& counts() override { return counts_; }

 private:
  Refusal rates(double t, const Array& y, const Array& out);
  /// Fills y and its rates from a state, unless they are those of the last accepted step.
  Refusal begin(const State&);
  void measure_radius(double t);

  const Judge<D, P>& judge_;
  SemiDiscrete<D, P> system_;
  std::unique_ptr<RungeKutta> scheme_;
  PowerIteration spectrum_;        ///< of the rates that limit the step
  PowerIteration stiff_spectrum_;  ///< of the stiff part, where the scheme needs it
  double safety_;
  Array y_, rates_, next_, next_rates_, probe_;
  double end_ = 0;
  bool known_rates_ = false;
  int age_ = 0, most_age_ = 0;  ///< of the spectral radius, in steps
  SolverCounts counts_;
};

}  // namespace softwet
