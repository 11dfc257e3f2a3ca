// Finding tools/verify and a python3 for it.
#include "app/host/verify.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "app/error.hpp"

namespace softwet {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string find_tool() {
  const std::string chosen = environment("SOFTWET_TOOLS");
  const std::string tool = (chosen.empty() ? SOFTWET_SOURCE_DIR "/tools" : chosen) + "/verify";
  if (std::filesystem::exists(tool)) return tool;
  if (!chosen.empty()) {
    throw Error(Exit::invalid_input, fmt::format("verify: SOFTWET_TOOLS = '{}' holds no file 'verify'; give the folder "
                                                 "tools of softwet's sources",
                                                 chosen));
  }
  throw Error(Exit::machine_failed, fmt::format("verify: '{}' is not there; the studies come with the sources: set "
                                                "SOFTWET_TOOLS to their folder tools",
                                                tool));
}

/// True where the interpreter starts and imports what the studies need.
bool serves(const std::string& python) {
  std::string quoted;
  for (char c : python) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return std::system(("'" + quoted + "' -c 'import numpy, h5py' >/dev/null 2>&1").c_str()) == 0;
}

std::string find_python() {
  const std::string chosen = environment("SOFTWET_PYTHON");
  if (!chosen.empty()) {
    if (serves(chosen)) return chosen;
    throw Error(Exit::invalid_input,
                fmt::format("verify: SOFTWET_PYTHON = '{}' does not start or has no numpy and h5py; give a python3 "
                            "that has them, or unset it",
                            chosen));
  }
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (serves(python)) return python;
  }
  throw Error(Exit::machine_failed,
              "verify: no python3 with numpy and h5py; on Debian: apt-get install python3-numpy python3-h5py, "
              "elsewhere set SOFTWET_PYTHON to one that has them");
}

}  // namespace

void verify_command(const std::vector<std::string>& words) {
  const std::string tool = find_tool(), self = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> line = {find_python(), tool, "--softwet", self};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : line) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  throw Error(Exit::machine_failed, fmt::format("verify: cannot start '{}': {}", line[0], std::strerror(errno)));
}

}  // namespace softwet
