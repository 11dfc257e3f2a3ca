// Whether a checkpoint belongs to a case.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// The lines "table.key = value" of a case that decide what is computed: all but the name, the output, the solver, the
/// end of the run and the size of its steps, which a resumed run may change.
std::string fingerprint(const Case&);

/// Throws Error (invalid_input) that names the first difference; `path` is that of the checkpoint.
void check_fingerprint(const std::string& path, const std::string& stored, const Case&);

}  // namespace softwet
