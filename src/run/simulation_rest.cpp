// How a scene comes to rest: before its first step, or as all that is asked of it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "case/error.hpp"
#include "case/text.hpp"
#include "observe/extremes.hpp"
#include "run/host/run_status.hpp"
#include "run/simulation.hpp"
#include "time/rest/rest_control.hpp"

namespace softwet {
namespace {

/// Rates that are zero twice are found with the root of their error.
constexpr double neutral_rate_of_drift = 1e-2;

[[noreturn]] void give_up_start(const std::string& why) {
  throw Error(Exit::computation_failed,
              "the scene does not come to rest (time.start = \"equilibrium\"): " + why +
                  "; write time.start = \"initial\" to compute its motion from the state of the case file");
}

std::string rest_text(const Relaxation& r, double speed) {
  return "at rest after " + std::to_string(r.steps) + " steps and " + std::to_string(r.newton) +
         " iterations of Newton's method: what is left of the equations is " + short_text(r.excess, 2) +
         " times what the last digit of the fields makes of them, " +
         (r.excess < digits_of_rest
              ? ""
              : "its fields change by " + short_text(r.rate, 2) + " of their range in a unit of time, ") +
         "the largest speed is " + short_text(speed, 2);
}

/// Whether nothing holds a solid alone along some axis. After a push it drifts for ever.
bool drifts(const Case& c) {
  if (c.fluid || !c.substrate) return false;
  const auto held = [&](int axis) {
    for (int d = 0; d < c.dimension(); ++d)
      for (const Side side : c.boundary.side[d])
        if (holds(side, d == axis)) return true;
    return false;
  };
  for (int axis = 0; axis < c.dimension(); ++axis)
    if (!held(axis)) return true;
  return false;
}

/// What the rate of the fastest mode says of a state.
std::string stability_text(const Case& c, const Growth& growth) {
  if (drifts(c) && (growth.rates.empty() || growth.rates[0].real() < neutral_rate_of_drift))
    return "neither stable nor unstable: nothing holds the solid along some axis, and after a push it drifts";
  if (!growth.why.empty()) return "whether that is stable is not known: " + growth.why;
  const double rate = growth.rates[0].real();
  const std::string time = short_text(1 / std::abs(rate), 3) + " units of time";
  if (std::abs(rate) < neutral_rate * std::max(1.0, std::abs(growth.rates[0])))
    return "neither stable nor unstable: a small disturbance stays, its rate is " + short_text(rate, 2);
  return rate > 0 ? "not stable: a small disturbance grows by the factor e within " + time
                  : "stable: the small disturbance that stays longest falls by the factor e within " + time;
}

}  // namespace

template <int D, int P>
bool Simulation<D, P>::come_to_rest(State& state) {
  scalars_.watch(state, "");
  // A load without a ramp acts after its start, not at it: on a state of rest that is asked for, not on one that a run starts from.
  const double time = state.time;
  if (options_.steady) state.time = std::nextafter(time, std::numeric_limits<double>::infinity());
  const double mass = model_.filling(stage_at(model_.layout(), state)).mass;
  double before = since_start();
  const auto interrupted = [&] {
    wall_clock_.step(since_start() - std::exchange(before, since_start()));
    return wish() != Wish::go_on;
  };
  relaxation_ = relax<D, P>(model_, case_, state, interrupted, [&](State now, const Relaxation& done) {
    now.time = time;
    scalars_.watch(now, " (while the scene came to rest)");
    progress_->settle(done.steps, done.rate);
  });
  if (relaxation_->interrupted) {
    const bool in_time = wish() == Wish::end_in_time;
    progress_->tell((in_time ? "time.wall_clock reached" : "stopped by user") +
                    std::string(" before the scene was at rest") + (options_.steady ? "" : " (time.start)") +
                    "; nothing was written, give the same command again" + (in_time ? " with more time" : ""));
    return false;
  }
  moved_ = scalars_.moved();
  const Extremes extremes = find_extremes(model_.layout(), state, 0);
  speed_at_rest_ = std::max(extremes.speed_fluid, extremes.speed_solid);
  mass_change_ = mass > 0 ? model_.filling(stage_at(model_.layout(), state)).mass / mass - 1 : 0;
  if (relaxation_->why.empty())
    progress_->tell(rest_text(*relaxation_, speed_at_rest_) + moves_text(body_names(case_), moved_));
  else if (!options_.steady)
    give_up_start(relaxation_->why);
  if (options_.steady && relaxation_->why.empty()) measure_stability(state);
  state.time = time;
  return true;
}

template <int D, int P>
void Simulation<D, P>::measure_stability(const State& state) {
  growth_ = growth_at_rest<D, P>(model_, case_, state, [&] { return wish() != Wish::go_on; });
  progress_->tell(stability_text(case_, *growth_));
}

template <int D, int P>
void Simulation<D, P>::end_at_rest() {
  if (!relaxation_->why.empty()) {
    stepper_.counts().last_rejection = relaxation_->refusal;
    throw Error(Exit::computation_failed, "no state of rest was found: " + relaxation_->why);
  }
  record(reason_of_rest);
  require_folder();
  progress_->tell("the result is in " + options_.out + summary(scalars_.events()));
}

template <int D, int P>
void Simulation<D, P>::record_rest(RunRecord& run) const {
  const Relaxation& r = *relaxation_;
  RecordValue& rest = run[options_.steady ? "rest" : "start"];
  rest["steps"] = r.steps;
  rest["rejected"] = r.rejected;
  rest["newton"] = r.newton;
  rest["krylov"] = r.krylov;
  rest["time"] = r.time;
  rest["rate_of_change"] = r.rate;
  rest["residual_over_round_off"] = r.excess;
  rest["largest_speed"] = speed_at_rest_;
  rest["mass_change"] = mass_change_;
  if (growth_) {
    RecordValue& stability = rest["stability"];
    stability["steps"] = growth_->steps;
    stability["krylov"] = growth_->krylov;
    for (const std::complex<double>& rate : growth_->rates) {
      stability["growth_rates"].append(rate.real());
      stability["frequencies"].append(rate.imag());
    }
  }
  for (const std::optional<double>& moved : moved_) rest["moved"].append(moved.value_or(NAN));  // null: it is gone
}

template bool Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::come_to_rest(State&);
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::end_at_rest();
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::record_rest(RunRecord&) const;

}  // namespace softwet
