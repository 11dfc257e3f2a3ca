// The command line of softwet: commands, options, exit codes.
#pragma once

namespace softwet {

/// Does what the command line says; every Error becomes one line on stderr. Returns the exit code of the program.
int run_command_line(int argc, const char* const* argv);

}  // namespace softwet
