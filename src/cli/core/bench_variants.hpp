// What `softwet bench --preconditioners` compares.
#pragma once

#include <ostream>

#include "case/case.hpp"

namespace softwet {

/// Prints for each form of the preconditioner what a build takes, what an iteration takes, and how many iterations of
/// GMRES a step of 0.1, 1 and 10 takes from the state after `time.max_steps` steps, at most 40.
template <int D, int P>
void compare_preconditioners(const Case&, std::ostream&);

}  // namespace softwet
