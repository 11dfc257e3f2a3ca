// Finding a file of the folder tools and a python3 for it.
#include "cli/tool.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "case/error.hpp"

namespace softwet {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The folder tools: the chosen one, else the one of the installation this program is part of, else the one of its
/// sources.
std::filesystem::path tools_folder(const std::filesystem::path& program) {
  if (const std::string chosen = environment("SOFTWET_TOOLS"); !chosen.empty()) return chosen;
  const auto installed = program.parent_path().parent_path() / "share/softwet/tools";
  return std::filesystem::is_directory(installed) ? installed : SOFTWET_SOURCE_DIR "/tools";
}

std::string find_file(const std::string& name, const std::filesystem::path& program) {
  const std::string folder = tools_folder(program).string(), file = folder + "/" + name;
  if (std::filesystem::exists(file)) return file;
  if (!environment("SOFTWET_TOOLS").empty()) {
    throw Error(
        Exit::invalid_input,
        fmt::format("{0}: SOFTWET_TOOLS = '{1}' holds no file '{0}'; give the folder tools of softwet's sources", name,
                    folder));
  }
  throw Error(
      Exit::machine_failed,
      fmt::format(
          "{}: '{}' is not there; install softwet again, or set SOFTWET_TOOLS to the folder tools of its sources", name,
          file));
}

/// True where the interpreter starts.
bool starts(const std::string& python) {
  std::string quoted;
  for (char c : python) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return std::system(fmt::format("'{}' -c '' >/dev/null 2>&1", quoted).c_str()) == 0;
}

/// The program chooses another one where it needs modules that this one lacks (tools/softwet/_tools/python.py).
std::string find_python(const std::string& name) {
  const std::string chosen = environment("SOFTWET_PYTHON");
  if (!chosen.empty()) {
    if (starts(chosen)) return chosen;
    throw Error(
        Exit::invalid_input,
        fmt::format("{}: SOFTWET_PYTHON = '{}' does not start; give a python3 that does, or unset it", name, chosen));
  }
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (starts(python)) return python;
  }
  throw Error(
      Exit::machine_failed,
      fmt::format("{}: no python3; on Debian: apt-get install python3, elsewhere set SOFTWET_PYTHON to one", name));
}

}  // namespace

void start_tool(const std::string& name, const std::vector<std::string>& words) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string(), file = find_file(name, self);
  std::vector<std::string> line = {find_python(name), file, "--softwet", self};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : line) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  throw Error(Exit::machine_failed, fmt::format("{}: cannot start '{}': {}", name, line[0], std::strerror(errno)));
}

}  // namespace softwet
