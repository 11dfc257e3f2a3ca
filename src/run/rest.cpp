#include "run/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/error.hpp"
#include "case/text.hpp"
#include "run/host/run_status.hpp"
#include "scene/initial.hpp"

namespace softwet {
namespace {

/// Rates that are zero twice are found with the root of their error.
constexpr double neutral_rate_of_drift = 1e-2;

/// Run time from which on all loads have their full strength.
double full_load_time(const Case& c) {
  double time = 0;
  for (const Load& load : c.loads) time = std::max(time, load.start + load.ramp);
  return time;
}

/// Whether nothing holds a solid alone along some axis. After a push it drifts forever.
bool drifts(const Case& c) {
  if (c.fluid || !c.substrate) return false;
  const auto held = [&](int axis) {
    for (int d = 0; d < c.dimension(); ++d)
      for (const Side side : c.boundary.side[d])
        if (holds(side, axis, d)) return true;
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
Rest<D, P>::Rest(const Case& c, const RunOptions& options)
    : case_(c),
      scene_(c),
      stepper_(scene_, c, {}),
      journal_(c, options, scene_, stepper_, {output_time(full_load_time(c), c.clock_zero())}),
      way_(c, scene_, journal_) {
  journal_.more_to_record = [this](RunRecord& run) { describe(run); };
}

template <int D, int P>
void Rest<D, P>::run() {
  journal_.require_memory();
  if (!begin()) return;
  journal_.end_setup();
  Case asked = case_;
  asked.time.start = StartState::equilibrium;  // what it looks for
  journal_.keep_state_of(asked, [this] {
    journal_.observe({});
    journal_.save();
    if (!way_.why_not().empty()) {
      stepper_.counts().last_rejection = way_.relaxation().refusal;
      throw Error(Exit::computation_failed, "no state of rest was found: " + way_.why_not());
    }
    journal_.record(reason_of_rest);
    journal_.require_folder();
    journal_.tell_of_result("");
  });
}

template <int D, int P>
bool Rest<D, P>::begin() {
  State state = initial_state<D, P>(case_, scene_);
  const double time = state.time = full_load_time(case_);
  // A load without a ramp acts after its start, not at it: on a state of rest that is asked for, not on one that a run
  // starts from.
  const double time_of_loads = std::nextafter(time, std::numeric_limits<double>::infinity());
  if (!way_.go(state, time_of_loads, "")) return false;
  if (way_.why_not().empty()) {
    state.time = time_of_loads;
    growth_ = growth_at_rest<D, P>(scene_, case_, state, [this] { return journal_.wish() != Wish::go_on; });
    journal_.tell(stability_text(case_, *growth_));
  }
  state.time = time;
  stepper_.scheme().initialise(state);
  stepper_.start(state);
  journal_.begin();
  return true;
}

template <int D, int P>
void Rest<D, P>::describe(RunRecord& run) const {
  RecordValue& rest = run["rest"];
  way_.describe(rest);
  if (!growth_) return;
  RecordValue& stability = rest["stability"];
  stability["steps"] = growth_->steps;
  stability["krylov"] = growth_->krylov;
  for (const std::complex<double>& rate : growth_->rates) {
    stability["growth_rates"].append(rate.real());
    stability["frequencies"].append(rate.imag());
  }
}

template class Rest<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
