// The program softwet. Everything is behind the command line.
#include "app/host/cli.hpp"

int main(int argc, char** argv) { return softwet::run_command_line(argc, argv); }
