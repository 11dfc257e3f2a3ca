// The commands that are programs of the folder tools, on the command line.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace softwet {

/// Adds the commands; what they are given is collected in `words`, which outlives `app`.
void add_tool_commands(CLI::App& app, std::vector<std::string>& words);

}  // namespace softwet
