// Completion of the command line by the shell.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace softwet {

/// A script for bash that completes commands and options of `app`, files, keys of a case and their choices.
std::string bash_completion(const CLI::App& app);

}  // namespace softwet
