#include "run/journal.hpp"

#include <algorithm>
#include <cmath>

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/checks/field_times.hpp"
#include "field/ranks.hpp"
#include "field/together.hpp"
#include "machine/memory.hpp"
#include "observe/interface_table.hpp"
#include "run/host/results.hpp"
#include "run/interrupt.hpp"
#include "run/machine.hpp"
#include "run/memory_parts.hpp"
#include "run/remedy.hpp"

namespace softwet {
namespace {

// Seconds.
constexpr double first_save = 60, record_pause = 15;

/// A device leaves a core to write files while the next steps run; on a processor all cores compute. Several processes hear of an error
/// together, after each file.
Writes writes_of(const RunOptions& options) {
  if (ranks::count() > 1) return Writes::in_turn;
  return options.writes.value_or(host_algorithms ? Writes::in_turn : Writes::beside_steps);
}

}  // namespace

template <int D, int P>
Journal<D, P>::Journal(const Case& c, const RunOptions& options, const Scene<D, P>& scene, Stepper<D, P>& stepper,
                       std::vector<double> field_times)
    : saves_(std::min(first_save, 60 * c.output.checkpoint_minutes), 60 * c.output.checkpoint_minutes),
      records_(record_pause, record_pause),
      wall_clock_(c.wall_clock),
      case_(c),
      options_(options),
      scene_(scene),
      stepper_(stepper),
      scalars_(c, scene),
      progress_(options.quiet || !ranks::root() ? Progress::Voice::silent : Progress::voice(),
                c.run_start() - c.clock_zero(), c.time.end),
      time_left_(c.clock_zero() + c.time.end, c.time.dt_max, c.time.max_steps,
                 c.time.implicit() ? StepsFollow::error : StepsFollow::stability),
      field_times_(std::move(field_times)),
      writer_(writes_of(options), run_on_all_cores),
      row_writer_(writes_of(options), run_on_all_cores) {
  seconds_.started = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// The factors of a preconditioner may be most of the memory; they are not there yet.
template <int D, int P>
void Journal<D, P>::require_memory() const {
  const double needed = total_bytes(case_, scene_.layout(), stepper_.scheme().preconditioner());
  together(
      [&] { on_host ? require_bytes(case_, needed) : require_device_bytes(case_, needed, device_bytes_to_be_had()); });
}

template <int D, int P>
void Journal<D, P>::begin() {
  on_root([this] {
    if (options_.begin) options_.begin();
    history_.emplace(TableFile::create(path("history.csv"), scalars_.columns()));
    interface_.emplace(TableFile::create(path("interface.csv"), interface_columns<D>()));
  });
}

template <int D, int P>
void Journal<D, P>::restore() {
  scalars_.restore(read_checkpoint<D, P>(path("checkpoint.h5"), case_, stepper_, scalars_.memory(), found_, seconds_));
  seconds_before_ = seconds_.total;
  first_step_ = stepper_.counts().steps;
  told_ = scalars_.events().size();
}

template <int D, int P>
void Journal<D, P>::resume() {
  std::vector<double> written;
  on_root([&] {
    open_tables();  // may be refused: before anything changes
    if (options_.begin) options_.begin();
    written = found_.field_times;
  });
  written_ = ranks::shared(written);
  write_fields_due();  // of a time that is new in the case
  finish_files();
}

template <int D, int P>
void Journal<D, P>::open_tables() {
  // The row of a last step that is not a multiple of output.history.every is dropped: the run continues after it.
  history_.emplace(TableFile::append_after(path("history.csv"), scalars_.columns(), found_.history));
  interface_.emplace(TableFile::append_after(path("interface.csv"), interface_columns<D>(), found_.interface));
}

template <int D, int P>
void Journal<D, P>::observe(const StepReport& report) {
  const long step = stepper_.counts().steps;
  if (step % case_.output.history_every == 0) write_row(report, RowIs::regular);
  write_fields_due();
  if (step > 0) {
    time_left_.step(step, stepper_.state().time, since_start());
    progress_.step(output_time(), step, report.dt, last_row_, time_left_.seconds());
  }
}

template <int D, int P>
void Journal<D, P>::write_state() {
  Stopwatch watch(seconds_.output);
  const double before = since_start();
  WrittenFiles files{{}, {}, written_};
  on_root([&] {
    history_->bring_to_disk();
    interface_->bring_to_disk();
    files.history = history_->kept();
    files.interface = interface_->kept();
  });
  seconds_.total = seconds_before_ + since_start();
  write_checkpoint<D, P>(path("checkpoint.h5"), case_, stepper_, scalars_.memory(), files, seconds_);
  record("running");
  wall_clock_.save(since_start() - before);
}

template <int D, int P>
void Journal<D, P>::tell_of_result(const std::string& before) {
  tell(before + "the result is in " + options_.out + summary(scalars_.events()));
  for (const std::string& line : result_lines(case_, last_row_, options_.laboratory)) progress_.add(line);
  for (const std::string& line : next_lines(case_, options_.out, !written_.empty())) progress_.add(line);
}

template <int D, int P>
void Journal<D, P>::record(const std::string& reason) {
  seconds_.total = seconds_before_ + since_start();
  const std::vector<double> memory = peak_memory_of_processes();
  on_root([&] { write_record(reason, memory); });
}

template <int D, int P>
void Journal<D, P>::write_record(const std::string& reason, const std::vector<double>& memory) {
  RunRecord run = describe_run<D, P>(case_, scene_, stepper_, seconds_, first_step_);
  for (double of_process : memory)
    if (memory.size() > 1) run["peak_memory_of_processes_mib"].append(of_process);
  add_status(run, {reason, output_time(), seconds_.started, time_left_.seconds(), scalars_.events()});
  for (const std::string& column : scalars_.columns())
    if (const TableRow::Cell cell = last_row_.cell(column)) run["last_row"][column] = *cell;
  if (more_to_record) more_to_record(run);
  run.write(path("run.json"));
}

template <int D, int P>
void Journal<D, P>::keep_state_of(const Case& asked, const std::function<void()>& compute) {
  try {
    compute();
  } catch (const Error& error) {
    if (error.code() == Exit::machine_failed && ranks::count() == 1)
      require_folder();  // somebody may have moved it while a file was being written
    if (error.code() != Exit::computation_failed) throw;
    const std::string advice = remedy(asked, stepper_.counts().last_rejection, output_time()), failure = error.what();
    const std::string fields = show_last_state();
    throw Error(error.code(), failure + "; " + advice + "; the last good state, that of t = " +
                                  short_text(output_time(), 6) + ", " + keep_after(failure) + fields);
  } catch (const std::exception& error) {               // memory or the device: the state is still the last good one
    if (ranks::count() == 1) keep_after(error.what());  // of several processes, this one alone has failed
    throw;
  }
}

template <int D, int P>
std::string Journal<D, P>::show_last_state() {
  try {
    finish_files();
    write_fields(output_time());
    finish_files();
    return ", its fields in " + path("fields");
  } catch (const std::exception& error) {
    return std::string("; its fields could not be written: ") + error.what();
  }
}

template <int D, int P>
std::string Journal<D, P>::keep_after(const std::string& failure) {
  std::string state = "is in " + path("checkpoint.h5"), lost;
  try {
    finish_files();
  } catch (const std::exception& error) {  // of a file of an earlier state
    lost = std::string("; ") + error.what();
  }
  try {
    save();
  } catch (const std::exception& error) {
    state = std::string("could not be kept: ") + error.what();
  }
  try {
    record("failed: " + failure);
  } catch (const std::exception&) {  // the failure itself is what the user has to hear of
  }
  return state + lost;
}

template <int D, int P>
void Journal<D, P>::keep_files_current() {
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
void Journal<D, P>::save() {
  require_folder();
  write_state();
}

template <int D, int P>
Wish Journal<D, P>::wish() {
  const bool must_step =
      options_.resume && stepper_.counts().steps == first_step_;  // without one it would come no further
  const bool over = wall_clock_.over(since_start()) && !must_step;
  const Wish mine = stop_requested() ? Wish::stop : over ? Wish::end_in_time : Wish::go_on;
  return static_cast<Wish>(std::lround(ranks::largest(static_cast<double>(mine))));
}

template <int D, int P>
void Journal<D, P>::step_done(double before) {
  wall_clock_.step(since_start() - before);
}

template class Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
