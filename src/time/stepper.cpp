#include "time/stepper.hpp"

#include <algorithm>

#include "case/error.hpp"
#include "case/text.hpp"
#include "scene/groups.hpp"
#include "scene/initial.hpp"
#include "time/choose_scheme.hpp"

namespace softwet {
namespace {

void copy_state(State& to, const State& from) {
  to.time = from.time;
  Kokkos::deep_copy(to.unknown, from.unknown);
  Kokkos::deep_copy(to.velocity_rate, from.velocity_rate);
  Kokkos::deep_copy(to.displacement, from.displacement);
  Kokkos::deep_copy(to.displacement_rate, from.displacement_rate);
  Kokkos::deep_copy(to.moment, from.moment);
  Kokkos::deep_copy(to.moment_rate, from.moment_rate);
  if (from.memory.extent(0) == 0) return;
  Kokkos::deep_copy(to.memory, from.memory);
  Kokkos::deep_copy(to.memory_rate, from.memory_rate);
  to.memory_shift = from.memory_shift;
}

/// A droplet oscillates in about sqrt(rho_l R^3 / sigma).
StepLimits step_limits(const Case& c) {
  StepLimits limits{c.time.dt_initial, c.time.dt_min, c.time.dt_max, c.time.tolerance};
  if (c.fluid && largest_radius(c) > 0) limits.slow = liquid_of(c).time_inertia();
  return limits;
}

std::vector<double> with(std::vector<double> events, const std::vector<double>& more) {
  events.insert(events.end(), more.begin(), more.end());
  return events;
}

}  // namespace

template <int D, int P>
Stepper<D, P>::Stepper(const Scene<D, P>& scene, const Case& c, std::vector<double> events)
    : scene_(scene),
      judge_(scene, c),
      scheme_(choose_scheme(scene, c, judge_)),
      loads_(c),
      control_(step_limits(c), with(std::move(events), loads_.kinks())),
      state_(empty_state(scene.layout())),
      previous_("stepper.previous", scene.layout().size()) {}

template <int D, int P>
void Stepper<D, P>::start(const State& state) {
  copy_state(state_, state);
  previous_dt_ = 0;
}

template <int D, int P>
void Stepper<D, P>::restore(const State& state, const Array& previous, double previous_dt, double proposed) {
  copy_state(state_, state);
  Kokkos::deep_copy(previous_, previous);
  previous_dt_ = previous_dt;
  control_.set_proposed(proposed);
}

template <int D, int P>
void Stepper<D, P>::meet_jump() {
  const double behind = loads_.behind(state_.time);
  if (behind == state_.time) return;
  state_.time = behind;
  previous_dt_ = 0;
  control_.begin_anew();
  scheme_->begin_anew();
}

template <int D, int P>
void Stepper<D, P>::stop_below_smallest(double largest) {
  counts_.last_rejection = {Refusal::beyond_bound};
  throw Error(Exit::computation_failed, "the computation stopped: the longest stable step, " + short_text(largest) +
                                            ", is shorter than time.dt_min = " + short_text(control_.smallest()) +
                                            ", for " + scheme_->limit(state_));
}

template <int D, int P>
StepReport Stepper<D, P>::step() {
  meet_jump();
  for (;;) {
    const double largest = scheme_->largest_step(state_, control_.proposed());
    if (!(largest >= control_.smallest())) stop_below_smallest(largest);
    const double smooth = loads_.longest(state_.time, control_.most());
    const double dt = control_.next(state_.time, std::min(largest, smooth), loads_.jump_at(state_.time + smooth));
    const StepAttempt tried = scheme_->attempt({state_, previous_, previous_dt_}, dt);
    if (!tried.refusal.empty()) {
      ++counts_.rejected_newton;
      counts_.last_rejection = tried.refusal;
      scheme_->refuse(tried.refusal);
      if (control_.reject(dt)) continue;
      throw Error(Exit::computation_failed, std::string("the computation stopped: ") + tried.refusal.text() +
                                                ", even with the smallest step (time.dt_min)");
    }
    if (tried.indicator > control_.rejection_level(dt) && control_.reject(dt)) {
      ++counts_.rejected_error;
      scheme_->refuse({});
      continue;
    }
    previous_dt_ = dt;
    scheme_->accept(state_, previous_);
    control_.accept(dt, tried.indicator, tried.laborious ? Effort::laborious : Effort::usual);
    ++counts_.steps;
    return {dt, tried.newton, tried.krylov, tried.indicator};
  }
}

template class Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
