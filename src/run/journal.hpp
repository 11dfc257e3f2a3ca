// What a run writes and says: tables, field files, checkpoints and record in its folder, and lines on the terminal.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/output_time.hpp"
#include "io/table_file.hpp"
#include "observe/scalars.hpp"
#include "run/host/file_writer.hpp"
#include "run/host/options.hpp"
#include "run/host/rhythm.hpp"
#include "run/host/time_left.hpp"
#include "run/host/wall_clock.hpp"
#include "run/progress.hpp"
#include "run/record.hpp"
#include "run/restart.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// Whether a row follows output.history.every, or is there for the last state.
enum class RowIs { regular, last };

/// What all processes are asked to do.
enum class Wish { go_on, end_in_time, stop };

/// The folder of a run that exists, and its voice. Of several processes the first one alone evaluates the observers,
/// writes and speaks; where it fails, all fail (field/together.hpp). The output clock is the computation clock minus
/// case.clock_zero().
template <int D, int P>
class Journal {
 public:
  /// @param field_times  t at which field files are due
  Journal(const Case&, const RunOptions&, const Scene<D, P>&, Stepper<D, P>&, std::vector<double> field_times);

  /// Throws Error (machine_failed) where the machine lacks the memory that the run needs.
  void require_memory() const;

  /// Tables without rows: the state of the stepper is the first one.
  void begin();
  /// Puts the stepper where the checkpoint was written. Nothing in the folder changes.
  void restore();
  /// Goes on behind the rows and files of the checkpoint.
  void resume();

  /// The row, fields and progress of a step.
  void observe(const StepReport&);
  void write_row(const StepReport&, RowIs);
  /// Brings checkpoint, history.csv and run.json up to date when their time has come.
  void keep_files_current();
  void save();
  void record(const std::string& reason);
  /// Ends the run where somebody has moved or removed its folder, or a table: what there still is gets the last state.
  /// Throws Error (machine_failed).
  void require_folder();
  /// Computes, and keeps the last good state of what fails. @param asked  the case whose remedies the user reads
  void keep_state_of(const Case& asked, const std::function<void()>& compute);

  void tell(const std::string& message) { progress_.tell(message); }
  /// Where the result is, what it came to, and what to do next with it.
  void tell_of_result(const std::string& before);
  Progress& progress() { return progress_; }
  Scalars<D, P>& scalars() { return scalars_; }

  double since_start() const { return std::chrono::duration<double>(Clock::now() - options_.begun).count(); }
  /// Adds the time since the start to that of the setup.
  void end_setup() { seconds_.setup += since_start(); }
  /// Takes note of a step that began at `before`, seconds since the start.
  void step_done(double before);
  /// Whether the user, or the time that the run has, asks it to stop. All processes get the same.
  Wish wish();
  double output_time() const { return softwet::output_time(stepper_.state().time, case_.clock_zero()); }
  double seconds_of_whole_run() const { return seconds_.total; }
  /// Steps of the run before this process.
  long first_step() const { return first_step_; }

  /// What else belongs in the record.
  std::function<void(RunRecord&)> more_to_record;

 private:
  void open_tables();
  void write_fields_due();
  /// Field files and rows of interface.csv of the state, which has this time, unless they are the last that there are.
  void write_fields(double time);
  /// Waits until the row that was begun is written, and takes note of it. Throws what has kept it from being written.
  void finish_row();
  /// Takes over the row that is written, and prints its events.
  void take_row();
  /// Waits until all that is written beside the steps is complete. Throws what has kept something from being written.
  void finish_files();
  void tell_events();
  void write_state();
  void require_tables();
  /// Tries to save after a failure. @return what became of the last good state: "is in out/checkpoint.h5"
  std::string keep_after(const std::string& failure);
  /// Tries to write the fields of the state at which a computation has stopped, for those who look for the place.
  /// @return what the user reads of it
  std::string show_last_state();
  /// @param memory  peak of each process, MiB
  void write_record(const std::string& reason, const std::vector<double>& memory);
  std::string path(const std::string& name) const { return options_.out + "/" + name; }

  using Clock = std::chrono::steady_clock;
  Rhythm saves_, records_;
  WallClock wall_clock_;
  const Case& case_;
  RunOptions options_;
  const Scene<D, P>& scene_;
  Stepper<D, P>& stepper_;
  Scalars<D, P> scalars_;
  std::optional<TableFile> history_, interface_;
  Progress progress_;
  TimeLeft time_left_;
  std::size_t told_ = 0;       ///< events the user has heard of
  TableRow last_row_;          ///< of history.csv
  TableRow next_row_;          ///< while it is being written
  RunSeconds seconds_;         ///< of the whole run
  double seconds_before_ = 0;  ///< the total at the resume
  long first_step_ = 0;
  std::vector<double> field_times_;  ///< at which field files are due
  WrittenFiles found_;               ///< of the run that this one goes on
  std::vector<double> written_;      ///< times of the field files there are, the last of them perhaps not yet whole
  // They end first, for their tasks read the others.
  FileWriter writer_;      ///< of field files and rows of interface.csv
  FileWriter row_writer_;  ///< of rows of history.csv
};

}  // namespace softwet
