// The checkpoint of a run: everything that a resumed run needs to go on as if it had not stopped.
#pragma once

#include <string>

#include "observe/scalars.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// Seconds of a run beside those that Newton's method counts.
struct RunSeconds {
  double setup = 0, observers = 0, output = 0, total = 0;
  double started = 0;  ///< when the first process of the run began, seconds since 1970
};

/// Writes all levels of the integrator, the step control, the memory of the history and what the run has cost, atomically. The lagged
/// preconditioner is not part of it: a resumed run builds a new one, so it agrees with an uninterrupted run to the
/// tolerance of the solver, not to the last bit. All processes of the run collect the arrays, and the first one writes.
template <int D, int P>
void write_checkpoint(const std::string& path, const Case&, Stepper<D, P>&, const HistoryMemory&, RunSeconds);

/// Puts a stepper and the seconds where the checkpoint was written. Throws Error (invalid_input).
template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case&, Stepper<D, P>&, RunSeconds&);

}  // namespace softwet
