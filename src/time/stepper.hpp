// One accepted time step: try, judge, accept or halve.
#pragma once

#include <memory>

#include "time/load_times.hpp"
#include "time/step/judge.hpp"
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
  Refusal last_rejection;
};

template <int D, int P>
class Stepper {
 public:
  /// @param events  times at which steps end, in addition to the times of the loads
  Stepper(const Scene<D, P>& scene, const Case& c, std::vector<double> events);

  /// Takes over a state without history: the first step is predicted constant.
  void start(const State& state);

  /// Advances by one accepted step. Where a load jumps it continues after the jump, and starts afresh: from the fields,
  /// without rates and history. Throws Error (computation_failed) when no step is small enough; the state is then still
  /// the last good one.
  StepReport step();

  /// Whether a jump of a load, at the time of the state, ends behind a later time: no step ends there.
  bool passes(double time) const { return state_.time < time && time <= loads_.behind(state_.time); }

  const State& state() const { return state_; }
  State& state() { return state_; }
  Array previous() const { return previous_; }
  double previous_dt() const { return previous_dt_; }
  void restore(const State& state, const Array& previous, double previous_dt, double proposed);

  const Scene<D, P>& scene() const { return scene_; }
  Scheme<D, P>& scheme() { return *scheme_; }
  StepControl& control() { return control_; }
  StepCounts& counts() { return counts_; }

 private:
  /// Goes on behind a jump of a load that is at the time of the state.
  void meet_jump();
  /// Throws Error (computation_failed) where no step as long as time.dt_min is stable.
  [[noreturn]] void stop_below_smallest(double largest);

  const Scene<D, P>& scene_;
  Judge<D, P> judge_;
  std::unique_ptr<Scheme<D, P>> scheme_;
  LoadTimes loads_;
  StepControl control_;
  State state_;
  Array previous_;
  double previous_dt_ = 0;
  StepCounts counts_;
};

}  // namespace softwet
