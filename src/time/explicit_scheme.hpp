// Runge-Kutta schemes on a scene: largest stable step, states and moments.
#pragma once

#include "time/judge.hpp"
#include "time/linearised.hpp"
#include "time/power_iteration.hpp"
#include "time/semi_discrete.hpp"
#include "time/side_density.hpp"
#include "time/stability_limit.hpp"
#include "time/step_watch.hpp"
#include "time/stiff_radius.hpp"

namespace softwet {

/// The largest stable step of the scheme for the linearised rates limits the step. It is searched for on differences of
/// rates and kept for a number of steps. That number depends on the steps of the search, so searches take half of a run at
/// most, and a tenth where the limit stays the same. Before that it is searched for anew where liquid meets a side, and
/// after a refused step. A step that grows as steps beyond the limit do is refused, and halved until it does so no longer.
template <int D, int P>
class ExplicitScheme final : public Scheme<D, P> {
 public:
  ExplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { system_.set_moments(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state) override;
  void refuse(const Refusal&) override;
  double largest_step(const State&) override;
  void visit_memory(StepMemory&, const State&) override;
  SolverCounts& counts() override { return counts_; }

 private:
  Refusal rates(double t, const Array& y, const Array& out);
  /// Fills y and its rates from a state, unless they are those of the last accepted step.
  Refusal begin(const State&);
  /// Of the stage.
  StepSigns signs(double t, const Integrals&) const;
  void measure_limit(double t);
  /// How long the limit is kept, in steps, after a search that took so many steps of the scheme.
  void plan_search(double before, int cost);
  /// Without a limit from before: the spectral radius tells about where it is. 0: there is no radius
  double limit_from_radius(double t);
  Refusal measure_stiff_part();
  /// Judges the stage at the end of a step.
  Refusal judge_end();

  const Model<D, P>& model_;
  const Judge<D, P>& judge_;
  SemiDiscrete<D, P> system_;
  std::unique_ptr<RungeKutta> scheme_;
  Linearised linear_;
  PowerIteration spectrum_;     ///< of the rates that limit the step
  StiffRadius stiff_spectrum_;  ///< where the scheme needs it
  StabilityLimit stability_;
  SideDensity<D> side_density_;
  StepWatch watch_;
  double safety_, limit_ = 0;
  Array y_, rates_, next_, next_rates_;
  double end_ = 0, tried_ = 0;  ///< of the last attempt
  StepSigns next_signs_;
  bool known_rates_ = false;
  int age_ = 0, most_age_ = 0;  ///< of the limit, in steps
  bool contact_ = false;        ///< liquid has met a side since the search
  bool alarm_ = false;          ///< a step was refused for its growth since the search
  int deaf_ = 0;     ///< steps after a search in which growth asks for none, for the last one did not explain it
  int growths_ = 0;  ///< steps refused in a row for their growth
  SolverCounts counts_;
};

}  // namespace softwet
