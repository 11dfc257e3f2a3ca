// The program softwet. Everything is behind the command line.
#include "app/host/cli.hpp"
#include "field/ranks.hpp"

int main(int argc, char** argv) {
  const softwet::Job job(argc, argv);
  return softwet::run_command_line(argc, argv);
}
