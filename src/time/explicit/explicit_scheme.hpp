// Explicit schemes on a scene: largest stable step, states and moments.
#pragma once

#include <cstdint>

#include "solver/recording.hpp"
#include "time/explicit/explicit_step.hpp"
#include "time/explicit/held_rate.hpp"
#include "time/step/judge.hpp"

namespace softwet {

/// A bound from the state before a step limits it (StepBound), for kick_drift in a solid without its swings (HeldRate).
/// A step whose end has a bound below it is refused, and a shorter one follows: so contact with a wall or a side, a
/// merger or a squeezed film cannot carry a run beyond its limit.
template <int D, int P>
class ExplicitScheme final : public Scheme<D, P> {
 public:
  ExplicitScheme(const Scene<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { system_.set_moments(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state, const Array& before) override;
  void refuse(const Refusal&) override {}  // what the next attempt begins with is untouched
  void begin_anew() override { begun_ = false; }
  double largest_step(const State&, double wish) override;
  std::string limit(const State&) override;
  void visit_memory(StepMemory&, const State&) override;
  SolverCounts& counts() override { return counts_; }

  /// What limits the next step from a state.
  const StepRates& rates() const { return rates_; }
  /// Steps that are recorded now: with solver.krylov.launch = "graph" on a device.
  int recordings() const { return recordings_ ? recordings_->count() : 0; }

 private:
  /// The rates that the step begins with; rates of the last accepted step are kept.
  Refusal begin(const State&);
  /// The stage of the system with its moments.
  BoundState bound_state(const ConstArray& moments) const;
  /// Starts the kernels of a step, the sums that the host needs of its end, and their copy to the host. The numbers of
  /// the step are prepared.
  Refusal start_kernels(const StepHistory&, double t, double dt);
  /// Starts these kernels, as one graph where steps are recorded.
  Refusal start_step(const StepHistory&, double dt);
  /// Whatever follows from this key and the prepared numbers may stay recorded: the vectors, of which a step has two
  /// sets, the loads that act, whether an error is computed, and memory that other code may let grow.
  std::vector<std::uintptr_t> key_of(const StepHistory&, double t_end) const;
  /// Why the end of a step is not admissible, once its numbers are there. Takes the rates and the indicator of the
  /// error.
  Refusal judge_end(const StepHistory&, double dt, double& indicator);

  const Judge<D, P>& judge_;
  SemiDiscrete<D, P> system_;
  std::unique_ptr<ExplicitStep<D, P>> step_;
  StepBound<D, P> bound_;
  HostNumbers of_bound_and_judge_, of_bound_,
      of_judge_;  ///< what the host asks for at the end of a step, and its parts
  std::unique_ptr<Recordings<std::vector<std::uintptr_t>>> recordings_;  ///< null: kernels start one by one
  double safety_;
  StepRates rates_, next_rates_;
  HeldRate held_;
  double end_ = 0, dt_ = 0;  ///< of the last attempt
  bool begun_ = false;
  SolverCounts counts_;
};

}  // namespace softwet
