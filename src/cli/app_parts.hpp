// Parts of the command line, and what follows from all of it. Each has the source of its name.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace softwet {

/// completion: a script for bash that completes commands and options of `app`, files, keys of a case and their choices.
std::string bash_completion(const CLI::App& app);
/// manual: the manual page softwet(1) in roff, with commands and options of `app`, and the keys of a case.
std::string manual_page(const CLI::App& app);
/// Adds the commands that are programs of the folder tools; what they are given is collected in `words`, which outlives
/// `app`.
void add_tool_commands(CLI::App& app, std::vector<std::string>& words);

}  // namespace softwet
