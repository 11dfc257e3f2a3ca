// The case that a command is asked for.
#pragma once

#include <string>

#include "casefile/case_file.hpp"
#include "cli/case_commands.hpp"

namespace softwet {

/// Where the results of a request lie.
std::string folder_of(const CaseRequest&, const Case&);

/// The case of a request, with the scheme that takes less time where it leaves that open; it says which. States of rest
/// are found by implicit steps, and a run that goes on keeps the scheme that it began with. Throws Error.
LaboratoryCase read_case_of(const CaseRequest&);

}  // namespace softwet
