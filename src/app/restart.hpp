// The checkpoint of a run: everything that a resumed run needs to go on as if it had not stopped.
#pragma once

#include <string>

#include "observe/scalars.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// Writes all levels of the integrator, the step control and the memory of the history, atomically. The lagged
/// preconditioner is not part of it: a resumed run builds a new one, so it agrees with an uninterrupted run to the
/// tolerance of the solver, not to the last bit.
template <int D, int P>
void write_checkpoint(const std::string& path, const Case&, Stepper<D, P>&, const HistoryMemory&);

/// Puts a stepper where the checkpoint was written. Throws Error (invalid_input).
template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case&, Stepper<D, P>&);

}  // namespace softwet
