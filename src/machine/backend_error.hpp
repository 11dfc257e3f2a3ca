// What the parallel runtime throws, as an error of the machine.
#pragma once

#include <string>

#include "case/error.hpp"

namespace softwet {

/// The error for what Kokkos throws: memory that is not there, a kernel that does not start, a lost device. Only the
/// first depends on the size of a case.
Error backend_error(const std::string& problem);

}  // namespace softwet
