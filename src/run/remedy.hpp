// What a user may do about a computation that stopped.
#pragma once

#include <string>

#include "case/case.hpp"
#include "case/refusal.hpp"

namespace softwet {

/// A sentence for the reason of the last rejected step, with the numbers of the case that decide.
/// @param time  of the last good state, on the clock of the results
std::string remedy(const Case&, const Refusal& refusal, double time);

}  // namespace softwet
