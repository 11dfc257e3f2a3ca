// The program softwet. Everything is behind the command line.
#include <fcntl.h>

#include <algorithm>
#include <csignal>
#include <string_view>

#include "cli/cli.hpp"
#include "cli/waiting.hpp"
#include "field/ranks.hpp"
#include "run/interrupt.hpp"

namespace {

/// Where somebody has closed standard input, output or error, the next file that is opened would take its place, and
/// get what the user reads.
void fill_standard_streams() {
  for (int descriptor : {0, 1, 2})
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != descriptor) return;
}

/// Commands that compute in this process stop where they choose to. `steady --along` is carried out by another program.
void hear_signals_of(std::string_view command, bool follows_key) {
  if (command == "run")
    softwet::hear_signals(
        {"softwet: stopping at the end of this step; a second signal ends the run at once\n",
         "softwet: ended at once by a second signal; the last state is in checkpoint.h5, if there is one: "
         "--resume continues from there\n"});
  if (command == "steady" && !follows_key)
    softwet::hear_signals({"softwet: stopping at the end of this step; a second signal ends the search at once\n",
                           "softwet: ended at once by a second signal; give the same command again\n"});
  if (command == "bench")
    softwet::hear_signals({"softwet: stopping after this measurement; a second signal ends it at once\n",
                           "softwet: ended at once by a second signal\n"});
  if (command == "run" || command == "steady") softwet::outlive_readers();  // what counts is in their files
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "run" || command == "bench") softwet::choose_waiting(argv);
  fill_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the system fails to be written, which can be reported
  const bool follows_key =
      std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word).substr(0, 7) == "--along"; });
  hear_signals_of(command, follows_key);  // before anything that takes time
  const softwet::Job job(argc, argv);
  return softwet::run_command_line(argc, argv);
}
