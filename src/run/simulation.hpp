// A run from its first state to its last: steps, observers, checkpoints.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "io/output_time.hpp"
#include "io/table_file.hpp"
#include "observe/scalars.hpp"
#include "run/host/options.hpp"
#include "run/host/rhythm.hpp"
#include "run/host/time_left.hpp"
#include "run/host/wall_clock.hpp"
#include "run/progress.hpp"
#include "run/record.hpp"
#include "run/restart.hpp"
#include "time/rest/growth.hpp"
#include "time/rest/relaxation.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// Computes a case in a folder that exists. Of several processes each computes its columns of the scene. The first one
/// alone evaluates the observers, writes and speaks; where it fails, all fail (field/together.hpp). The output clock is
/// the computation clock minus case.clock_zero().
template <int D, int P>
class Simulation {
 public:
  Simulation(const Case& c, const RunOptions& options);

  /// To time.end, time.max_steps, time.wall_clock, Ctrl-C. Throws Error (computation_failed) after a checkpoint of the last good state.
  void run();

 private:
  /// False: it was asked to stop before the first state was there.
  bool begin();
  /// The same for a scene that begins at rest, or that is asked for nothing else.
  bool come_to_rest(State&);
  /// Whether the state at rest is stable.
  void measure_stability(const State&);
  /// Ends a run that was asked for the state at rest. Throws Error (computation_failed) where there is none.
  void end_at_rest();
  void record_rest(RunRecord&) const;
  void restore();
  void resume();
  void open_tables();
  void advance();
  void observe(const StepReport& report);
  void write_row(const StepReport& report);
  void write_fields_due();
  void tell_events();
  /// Brings checkpoint, history.csv and run.json up to date when their time has come.
  void keep_files_current();
  void save();
  void write_state();
  /// Ends the run where somebody has moved or removed its folder, or a table: what there still is gets the last state.
  /// Throws Error (machine_failed).
  void require_folder();
  void require_tables();
  /// Tries to save after a failure. @return what became of the last good state: "is in out/checkpoint.h5"
  std::string keep_after(const std::string& failure);
  void record(const std::string& reason);
  /// @param memory  peak of each process, MiB
  void write_record(const std::string& reason, const std::vector<double>& memory);
  /// Why nothing is left to compute; empty where there is.
  std::string completed();
  /// What all processes are asked to do.
  enum class Wish { go_on, end_in_time, stop };
  Wish wish();
  /// Whether a run that goes on has not taken a step yet: without one it would come no further, however often it is resumed.
  bool must_step() { return options_.resume && stepper_.counts().steps == first_step_; }
  std::string stop_reason();

  bool at_end() const;
  double since_start() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double output_time() const { return softwet::output_time(stepper_.state().time, case_.clock_zero()); }
  std::string path(const std::string& name) const { return options_.out + "/" + name; }

  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Rhythm saves_, records_;
  WallClock wall_clock_;
  const Case& case_;
  RunOptions options_;
  Model<D, P> model_;
  Stepper<D, P> stepper_;
  Scalars<D, P> scalars_;
  std::optional<TableFile> history_, interface_;
  std::optional<Progress> progress_;
  std::optional<Relaxation> relaxation_;
  std::optional<Growth> growth_;                ///< of disturbances of the state at rest
  double speed_at_rest_ = 0, mass_change_ = 0;  ///< the largest one there; of the mass on the way, relative
  std::vector<std::optional<double>> moved_;    ///< how far each body went on the way to rest
  TimeLeft time_left_;
  std::size_t told_ = 0;       ///< events the user has heard of
  TableRow last_row_;          ///< of history.csv
  RunSeconds seconds_;         ///< of the whole run
  double seconds_before_ = 0;  ///< the total at the resume
  long first_step_ = 0;
  std::vector<double> field_times_;  ///< at which field files are due
  std::vector<double> written_;      ///< times of the field files there are
  WrittenFiles found_;               ///< of the run that this one goes on
};

}  // namespace softwet
