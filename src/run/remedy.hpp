// What a user may do about a computation that stopped.
#pragma once

#include <string>

#include "case/case.hpp"
#include "case/refusal.hpp"

namespace softwet {

/// A sentence for the reason of the last rejected step, with the numbers of the case that decide.
std::string remedy(const Case&, const Refusal& refusal);

}  // namespace softwet
