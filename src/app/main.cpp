// The program softwet. Everything is behind the command line.
#include <csignal>
#include <string_view>

#include "app/host/cli.hpp"
#include "app/interrupt.hpp"
#include "field/ranks.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the system fails to be written, which can be told
  if (argc > 1 && std::string_view(argv[1]) == "run") softwet::hear_signals();  // before anything that takes time
  const softwet::Job job(argc, argv);
  return softwet::run_command_line(argc, argv);
}
