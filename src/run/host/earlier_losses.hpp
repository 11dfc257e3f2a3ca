// What a run that starts from the result of another one does not take from it.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Sentences for the user, each with both values and what to write: another prestretch, whose displacement means
/// another shape, and the stress of branches, which is in no state. Empty where nothing of that matters.
/// @param folder  of the earlier run, whose history.csv knows the energy of its branches
std::vector<std::string> losses_of_earlier(const Case& now, const Case& then, const std::string& folder);

}  // namespace softwet
