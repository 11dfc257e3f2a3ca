#include "run/motion.hpp"

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/checks/field_times.hpp"
#include "casefile/checks/grading_advice.hpp"
#include "run/remedy.hpp"
#include "scene/initial.hpp"

namespace softwet {
namespace {

/// Times on the clock of the computation that a step has to end at.
std::vector<double> events(const Case& c) {
  const double zero = c.clock_zero();
  std::vector<double> times{zero, zero + c.time.end};
  for (double t : field_times(c)) times.push_back(zero + t);
  return times;
}

[[noreturn]] void give_up_start(const std::string& why, const std::string& advice) {
  throw Error(Exit::computation_failed,
              "the scene does not come to rest (time.start = \"equilibrium\"): " + why + "; " + advice +
                  "; time.start = \"initial\" computes its motion from the state of the case file");
}

}  // namespace

template <int D, int P>
Motion<D, P>::Motion(const Case& c, const RunOptions& options)
    : case_(c),
      resumes_(options.resume),
      scene_(c),
      stepper_(scene_, c, events(c)),
      journal_(c, options, scene_, stepper_, field_times(c)),
      way_to_rest_(c, scene_, journal_) {}

template <int D, int P>
void Motion<D, P>::run() {
  journal_.require_memory();
  if (!(resumes_ ? resume() : begin())) return;
  journal_.end_setup();
  journal_.keep_state_of(case_, [this] {
    if (resumes_) {
      journal_.record("running");
    } else {
      journal_.observe({});
      journal_.save();
    }
    advance();
  });
}

template <int D, int P>
bool Motion<D, P>::begin() {
  State state = initial_state<D, P>(case_, scene_);
  state.time = case_.run_start();
  if (case_.time.start == StartState::equilibrium) {
    journal_.more_to_record = [this](RunRecord& run) { way_to_rest_.describe(run["start"]); };
    if (!way_to_rest_.go(state, state.time, " (time.start)")) return false;
    if (!way_to_rest_.why_not().empty())
      give_up_start(way_to_rest_.why_not(), remedy(case_, way_to_rest_.relaxation().refusal, case_.run_start()));
  }
  stepper_.scheme().initialise(state);
  stepper_.start(state);
  journal_.begin();
  return true;
}

template <int D, int P>
bool Motion<D, P>::resume() {
  journal_.restore();
  const std::string time = "t = " + short_text(journal_.output_time(), 6);
  if (!completed().empty()) {
    journal_.tell("nothing is left to compute: " + completed() + " at " + time + "; to go on, raise " +
                  (at_end() ? "time.end" : "time.max_steps"));
    return false;
  }
  journal_.tell("resumed at " + time);
  journal_.resume();
  return true;
}

template <int D, int P>
void Motion<D, P>::advance() {
  StepReport report;
  while (stop_reason().empty()) {
    const double before = journal_.since_start();
    report = stepper_.step();
    journal_.observe(report);
    journal_.keep_files_current();
    journal_.step_done(before);
  }
  const long steps = stepper_.counts().steps;
  if (steps > journal_.first_step() && steps % case_.output.history_every != 0) journal_.write_row(report, RowIs::last);
  journal_.save();
  const std::string reason = stop_reason();
  journal_.record(reason);
  journal_.require_folder();  // what was written in this moment may be somewhere else
  const bool in_vain = reason == "time.wall_clock reached" && steps <= journal_.first_step() + 1;
  if (const std::string advice = advice_on_grading(case_); reason == "end reached" && !advice.empty())
    journal_.tell(advice);
  const std::string more = reason == "end reached" ? ""
                           : in_vain ? "; to go on, run the same command with --resume and with more time: this one is "
                                       "enough for one step of each start"
                                     : "; to go on, run the same command with --resume";
  journal_.tell_of_result(reason + " at t = " + short_text(journal_.output_time(), 6) + " after " +
                          std::to_string(steps) + " steps and " + short_text(journal_.seconds_of_whole_run(), 6) +
                          " s" + more + "; ");
}

template <int D, int P>
bool Motion<D, P>::at_end() const {
  const double t = journal_.output_time();
  return t >= case_.time.end || same_time(t, case_.time.end) || stepper_.passes(case_.clock_zero() + case_.time.end);
}

template <int D, int P>
std::string Motion<D, P>::completed() {
  if (at_end()) return "end reached";
  return stepper_.counts().steps >= case_.time.max_steps ? "time.max_steps reached" : "";
}

template <int D, int P>
std::string Motion<D, P>::stop_reason() {
  if (const std::string reason = completed(); !reason.empty()) return reason;
  switch (journal_.wish()) {
    case Wish::stop:
      return "stopped by user";
    case Wish::end_in_time:
      return "time.wall_clock reached";
    case Wish::go_on:
      break;
  }
  return "";
}

template class Motion<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
