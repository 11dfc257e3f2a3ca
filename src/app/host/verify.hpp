// `softwet verify`: hands over to tools/verify, which runs the studies of tests/verification/studies.
#pragma once

#include <string>
#include <vector>

namespace softwet {

/// Replaces this program by a python3 with numpy and h5py that runs tools/verify with `words` and the path of this program.
/// tools/ is SOFTWET_TOOLS, else that of the source folder of the build; python3 is SOFTWET_PYTHON, else python3, else
/// /usr/bin/python3. Throws Error: invalid_input where SOFTWET_TOOLS or SOFTWET_PYTHON name nothing of use, machine_failed
/// where tools or Python are missing.
[[noreturn]] void verify_command(const std::vector<std::string>& words);

}  // namespace softwet
