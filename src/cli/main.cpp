// The program softwet. Everything is behind the command line.
#include <fcntl.h>

#include <csignal>
#include <string_view>

#include "cli/cli.hpp"
#include "cli/waiting.hpp"
#include "field/ranks.hpp"
#include "run/interrupt.hpp"

namespace {

/// Where somebody has closed standard input, output or error, the next file that is opened would take its place, and get
/// what is told to the user.
void fill_standard_streams() {
  for (int descriptor : {0, 1, 2})
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != descriptor) return;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "run" || command == "bench") softwet::choose_waiting(argv);
  fill_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the system fails to be written, which can be told
  if (command == "run") softwet::hear_signals();  // before anything that takes time
  const softwet::Job job(argc, argv);
  return softwet::run_command_line(argc, argv);
}
