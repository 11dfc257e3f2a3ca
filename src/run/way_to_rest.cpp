#include "run/way_to_rest.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/text.hpp"
#include "observe/extremes.hpp"
#include "run/host/run_status.hpp"
#include "time/rest/rest_control.hpp"

namespace softwet {
namespace {

std::string rest_text(const Relaxation& r, double speed) {
  return "at rest after " + std::to_string(r.steps) + " steps and " + std::to_string(r.newton) +
         " iterations of Newton's method: what is left of the equations is " + short_text(r.excess, 2) +
         " times what the last digit of the fields makes of them, " +
         (r.excess < digits_of_rest
              ? ""
              : "its fields change by " + short_text(r.rate, 2) + " of their range in a unit of time, ") +
         "the largest speed is " + short_text(speed, 2);
}

}  // namespace

template <int D, int P>
bool WayToRest<D, P>::go(State& state, double time_of_loads, const std::string& asked_by) {
  Scalars<D, P>& scalars = journal_.scalars();
  scalars.watch(state, "");
  const double time = std::exchange(state.time, time_of_loads);
  const double mass = scene_.balance().filling(stage_at(scene_.layout(), state)).mass;
  double before = journal_.since_start();
  const auto interrupted = [&] {
    journal_.step_done(std::exchange(before, journal_.since_start()));
    return journal_.wish() != Wish::go_on;
  };
  relaxation_ = relax<D, P>(scene_, case_, state, interrupted, [&](State now, const Relaxation& done) {
    now.time = time;
    scalars.watch(now, " (while the scene came to rest)");
    journal_.progress().settle(done.steps, done.rate);
  });
  state.time = time;
  if (relaxation_->interrupted) {
    const bool in_time = journal_.wish() == Wish::end_in_time;
    journal_.tell((in_time ? "time.wall_clock reached" : "stopped by user") +
                  std::string(" before the scene was at rest") + asked_by +
                  "; nothing was written, give the same command again" + (in_time ? " with more time" : ""));
    return false;
  }
  moved_ = scalars.moved();
  const Extremes extremes = find_extremes(scene_.layout(), state, 0);
  speed_ = std::max(extremes.speed_fluid, extremes.speed_solid);
  mass_change_ = mass > 0 ? scene_.balance().filling(stage_at(scene_.layout(), state)).mass / mass - 1 : 0;
  if (relaxation_->why.empty()) journal_.tell(rest_text(*relaxation_, speed_) + moves_text(body_names(case_), moved_));
  return true;
}

template <int D, int P>
void WayToRest<D, P>::describe(RecordValue& rest) const {
  const Relaxation& r = *relaxation_;
  rest["steps"] = r.steps;
  rest["rejected"] = r.rejected;
  rest["newton"] = r.newton;
  rest["krylov"] = r.krylov;
  rest["time"] = r.time;
  rest["rate_of_change"] = r.rate;
  rest["residual_over_round_off"] = r.excess;
  rest["largest_speed"] = speed_;
  rest["mass_change"] = mass_change_;
  for (const std::optional<double>& moved : moved_) rest["moved"].append(moved.value_or(NAN));  // null: it is gone
}

template class WayToRest<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
