// The checkpoint of a run: everything that a resumed run needs to go on as if it had not stopped.
#pragma once

#include <string>

#include "observe/scalars.hpp"
#include "run/host/run_memory.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// Seconds of a run beside those that Newton's method counts.
struct RunSeconds {
  double setup = 0, observers = 0, output = 0, total = 0;
  double started = 0;  ///< when the first process of the run began, seconds since 1970
};

/// Writes, atomically, all levels of the integrator, the step control, what the time scheme remembers, the memory of
/// the history, what was written beside it, and what the run has cost. All processes of the run collect the arrays, and
/// the first one writes; it alone needs `files`.
///
/// Nothing of the run changes by it, and a run that is resumed from it continues with the bits of one that never
/// stopped: on any number of threads and processes, whenever and how often it was stopped. An explicit scheme keeps
/// what bounded its last steps. An implicit one keeps the stage from which its preconditioner was built; to
/// build it from there is deterministic.
template <int D, int P>
void write_checkpoint(const std::string& path, const Case&, Stepper<D, P>&, const HistoryMemory&,
                      const WrittenFiles& files, RunSeconds);

/// Puts a stepper, the seconds and the list of files where the checkpoint was written. What the scheme remembered is
/// left out where a key of the solver has changed since, and where this program computes the preconditioner in another
/// way: a new preconditioner is built then, and the run agrees with an undisturbed one up to the tolerance of the
/// solver.
/// @param at_start  what a row of history.csv knows at the start of this case
/// Throws Error (invalid_input), and leaves the stepper as it was, where the checkpoint is damaged, of another case or
/// of another format.
template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case&, Stepper<D, P>&, const HistoryMemory& at_start,
                              WrittenFiles& files, RunSeconds&);

}  // namespace softwet
