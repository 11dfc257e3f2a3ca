// Whether a checkpoint belongs to a case.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// The lines "table.key = value" of a case that decide what is computed. A resumed run may change all others: the name,
/// the output, the solver, time.end, time.max_steps, and what sets the size of the steps (time.tolerance, time.dt_*).
std::string fingerprint(const Case&);

/// The lines of the solver. A run continues with the bits of an undisturbed one where they are as they were.
std::string solver_settings(const Case&);

/// Throws Error (invalid_input) that names the first difference; `path` is the path of the checkpoint.
void check_fingerprint(const std::string& path, const std::string& stored, const Case&);

}  // namespace softwet
