// Commands that are Python programs of the folder tools: `softwet verify`, `sweep`, `tradeoff`, `status`, `watch`.
#pragma once

#include <string>
#include <vector>

namespace softwet {

/// Replaces this program by a python3 that runs tools/<name> with `words` and the path of this program. tools/ is
/// SOFTWET_TOOLS, else share/softwet/tools of the installation this program is part of, else tools/ of the sources it
/// was built from; python3 is SOFTWET_PYTHON, else python3, else /usr/bin/python3: the first that starts. Throws Error:
/// invalid_input where SOFTWET_TOOLS or SOFTWET_PYTHON name nothing of use, machine_failed where tools or Python are
/// missing.
[[noreturn]] void start_tool(const std::string& name, const std::vector<std::string>& words);

}  // namespace softwet
