#include "run/simulation.hpp"

#include <cmath>
#include <utility>

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/checks/field_times.hpp"
#include "field/ranks.hpp"
#include "field/together.hpp"
#include "machine/memory.hpp"
#include "model/initial.hpp"
#include "observe/interface_table.hpp"
#include "run/interrupt.hpp"
#include "run/machine.hpp"
#include "run/memory_parts.hpp"
#include "run/remedy.hpp"

namespace softwet {
namespace {

// Seconds.
constexpr double first_save = 60, record_pause = 15;

/// Times on the clock of the computation that a step has to end at.
std::vector<double> events(const Case& c) {
  const double zero = c.clock_zero();
  std::vector<double> times{zero, zero + c.time.end};
  for (double t : field_times(c)) times.push_back(zero + t);
  return times;
}

/// Run time from which on all loads have their full strength.
double full_load_time(const Case& c) {
  double time = 0;
  for (const Load& load : c.loads) time = std::max(time, load.start + load.ramp);
  return time;
}

}  // namespace

template <int D, int P>
Simulation<D, P>::Simulation(const Case& c, const RunOptions& options)
    : saves_(std::min(first_save, 60 * c.output.checkpoint_minutes), 60 * c.output.checkpoint_minutes),
      records_(record_pause, record_pause),
      wall_clock_(c.wall_clock),
      case_(c),
      options_(options),
      model_(c),
      stepper_(model_, c, events(c)),
      scalars_(c, model_),
      time_left_(c.clock_zero() + c.time.end, c.time.dt_max, c.time.max_steps),
      field_times_(field_times(c)) {
  seconds_.started = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

template <int D, int P>
bool Simulation<D, P>::at_end() const {
  const double t = output_time();
  return t >= case_.time.end || same_time(t, case_.time.end);
}

template <int D, int P>
bool Simulation<D, P>::begin() {
  State state = initial_state<D, P>(case_, model_);
  state.time = options_.steady ? full_load_time(case_) : case_.run_start();
  if (options_.steady) field_times_ = {softwet::output_time(state.time, case_.clock_zero())};
  if ((options_.steady || case_.time.start == StartState::equilibrium) && !come_to_rest(state)) return false;
  stepper_.scheme().initialise(state);
  stepper_.start(state);
  on_root([this] {
    if (options_.begin) options_.begin();
    history_.emplace(TableFile::create(path("history.csv"), scalars_.columns()));
    interface_.emplace(TableFile::create(path("interface.csv"), interface_columns<D>()));
  });
  return true;
}

template <int D, int P>
void Simulation<D, P>::restore() {
  scalars_.restore(read_checkpoint<D, P>(path("checkpoint.h5"), case_, stepper_, scalars_.memory(), found_, seconds_));
  seconds_before_ = seconds_.total;
  first_step_ = stepper_.counts().steps;
  told_ = scalars_.events().size();
}

template <int D, int P>
void Simulation<D, P>::resume() {
  std::vector<double> written;
  on_root([&] {
    open_tables();  // may be refused: before anything changes
    if (options_.begin) options_.begin();
    written = found_.field_times;
  });
  written_ = ranks::shared(written);
  write_fields_due();  // of a time that is new in the case
}

template <int D, int P>
void Simulation<D, P>::open_tables() {
  // The row of a last step that is no multiple of output.history.every is dropped: the run goes on behind it.
  history_.emplace(TableFile::append_after(path("history.csv"), scalars_.columns(), found_.history));
  interface_.emplace(TableFile::append_after(path("interface.csv"), interface_columns<D>(), found_.interface));
}

template <int D, int P>
void Simulation<D, P>::run() {
  // The factors of a preconditioner may be most of the memory; they are not there yet.
  const double needed = total_bytes(case_, model_.layout(), stepper_.scheme().preconditioner());
  together(
      [&] { on_host ? require_bytes(case_, needed) : require_device_bytes(case_, needed, device_bytes_to_be_had()); });
  progress_.emplace(Progress::voice(options_.quiet || !ranks::root()), case_.run_start() - case_.clock_zero(),
                    case_.time.end);
  if (!options_.resume && !begin()) return;
  if (options_.resume) {
    restore();
    const std::string place = completed() + " at t = " + short_text(output_time(), 6);
    if (!completed().empty())
      return progress_->tell("nothing is left to compute: " + place + "; to go on, raise " +
                             (at_end() ? "time.end" : "time.max_steps"));
    progress_->tell("resumed at t = " + short_text(output_time(), 6));
    resume();
  }
  seconds_.setup += since_start();
  try {
    if (options_.resume) {
      record("running");
    } else {
      observe({});
      save();
    }
    if (options_.steady) return end_at_rest();
    advance();
  } catch (const Error& error) {
    if (error.code() == Exit::machine_failed && ranks::count() == 1)
      require_folder();  // somebody may have moved it while a file was being written
    if (error.code() != Exit::computation_failed) throw;
    Case asked = case_;
    if (options_.steady) asked.time.start = StartState::equilibrium;  // what it looks for
    const std::string advice = remedy(asked, stepper_.counts().last_rejection, output_time()), failure = error.what();
    throw Error(error.code(), failure + "; " + advice + "; the last good state, that of t = " +
                                  short_text(output_time(), 6) + ", " + keep_after(failure));
  } catch (const std::exception& error) {               // memory or the device: the state is still the last good one
    if (ranks::count() == 1) keep_after(error.what());  // of several processes, this one alone has failed
    throw;
  }
}

template <int D, int P>
std::string Simulation<D, P>::keep_after(const std::string& failure) {
  std::string state = "is in " + path("checkpoint.h5");
  try {
    save();
  } catch (const std::exception& error) {
    state = std::string("could not be kept: ") + error.what();
  }
  try {
    record("failed: " + failure);
  } catch (const std::exception&) {  // the failure itself is what the user has to hear of
  }
  return state;
}

template <int D, int P>
void Simulation<D, P>::advance() {
  StepReport report;
  while (stop_reason().empty()) {
    const double before = since_start();
    report = stepper_.step();
    time_left_.step(stepper_.counts().steps, stepper_.state().time, since_start());
    observe(report);
    keep_files_current();
    wall_clock_.step(since_start() - before);
  }
  const long steps = stepper_.counts().steps;
  if (steps > first_step_ && steps % case_.output.history_every != 0) write_row(report);
  save();
  const std::string reason = stop_reason();
  record(reason);
  require_folder();  // what was written in this moment may be somewhere else
  const bool in_vain = reason == "time.wall_clock reached" && steps <= first_step_ + 1;
  const std::string more = reason == "end reached" ? ""
                           : in_vain ? "; to go on, run the same command with --resume and with more time: this one is "
                                       "enough for one step of each start"
                                     : "; to go on, run the same command with --resume";
  progress_->tell(reason + " at t = " + short_text(output_time(), 6) + " after " + std::to_string(steps) +
                  " steps and " + short_text(seconds_.total, 6) + " s" + more + "; the result is in " + options_.out +
                  summary(scalars_.events()));
}

template <int D, int P>
std::string Simulation<D, P>::completed() {
  if (at_end()) return "end reached";
  return stepper_.counts().steps >= case_.time.max_steps ? "time.max_steps reached" : "";
}

template <int D, int P>
typename Simulation<D, P>::Wish Simulation<D, P>::wish() {
  const bool over = wall_clock_.over(since_start()) && !must_step();
  const Wish mine = stop_requested() ? Wish::stop : over ? Wish::end_in_time : Wish::go_on;
  return static_cast<Wish>(std::lround(ranks::largest(static_cast<double>(mine))));
}

template <int D, int P>
std::string Simulation<D, P>::stop_reason() {
  if (const std::string reason = completed(); !reason.empty()) return reason;
  switch (wish()) {
    case Wish::stop:
      return "stopped by user";
    case Wish::end_in_time:
      return "time.wall_clock reached";
    case Wish::go_on:
      break;
  }
  return "";
}

template <int D, int P>
void Simulation<D, P>::keep_files_current() {
  enum Due { nothing, of_record, of_save };
  const Due due = saves_.due(since_start()) ? of_save : records_.due(since_start()) ? of_record : nothing;
  switch (static_cast<Due>(ranks::of_root(due))) {  // whose clock counts
    case of_save:
      return save();
    case of_record:
      require_folder();
      on_root([this] { history_->flush(); });
      return record("running");
    case nothing:
      return;
  }
}

template <int D, int P>
void Simulation<D, P>::save() {
  require_folder();
  write_state();
}

template class Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
