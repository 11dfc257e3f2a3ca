// Finding a file of the folder tools and a python3 for it.
#include "cli/tool.hpp"

#include <fmt/ranges.h>
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

/// The folder tools: the chosen one, else that of the installation this program is part of, else that of its sources.
std::filesystem::path tools_folder(const std::filesystem::path& program) {
  if (const std::string chosen = environment("SOFTWET_TOOLS"); !chosen.empty()) return chosen;
  const auto installed = program.parent_path().parent_path() / "share/softwet/tools";
  return std::filesystem::is_directory(installed) ? installed : SOFTWET_SOURCE_DIR "/tools";
}

std::string find_file(const std::string& name, const std::filesystem::path& program) {
  const std::string folder = tools_folder(program).string(), file = folder + "/" + name;
  if (std::filesystem::exists(file)) return file;
  if (!environment("SOFTWET_TOOLS").empty()) {
    throw Error(Exit::invalid_input,
                fmt::format("{0}: SOFTWET_TOOLS = '{1}' holds no file '{0}'; give the folder tools "
                            "of softwet's sources",
                            name, folder));
  }
  throw Error(Exit::machine_failed,
              fmt::format("{}: '{}' is not there; install softwet again, or set SOFTWET_TOOLS to the folder tools of "
                          "its sources",
                          name, file));
}

/// True where the interpreter starts and imports the modules.
bool serves(const std::string& python, const std::vector<std::string>& modules) {
  std::string quoted;
  for (char c : python) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  const std::string imports = fmt::format("import {}", fmt::join(modules, ", "));
  return std::system(fmt::format("'{}' -c '{}' >/dev/null 2>&1", quoted, modules.empty() ? "" : imports).c_str()) == 0;
}

std::string find_python(const Tool& tool) {
  const std::string chosen = environment("SOFTWET_PYTHON");
  const std::string needed = fmt::format("{}", fmt::join(tool.modules, " and "));
  if (!chosen.empty()) {
    if (serves(chosen, tool.modules)) return chosen;
    throw Error(Exit::invalid_input,
                fmt::format("{}: SOFTWET_PYTHON = '{}' does not start{}; give a python3 that does, or unset it",
                            tool.name, chosen, needed.empty() ? "" : " or has no " + needed));
  }
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (serves(python, tool.modules)) return python;
  }
  std::string packages = tool.modules.empty() ? " python3" : "";
  for (const std::string& module : tool.modules) packages += " python3-" + module;
  throw Error(Exit::machine_failed,
              fmt::format("{}: no python3{}; on Debian: apt-get install{}, elsewhere set SOFTWET_PYTHON to one",
                          tool.name, needed.empty() ? "" : " with " + needed, packages));
}

}  // namespace

void start_tool(const Tool& tool, const std::vector<std::string>& words) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string(), file = find_file(tool.name, self);
  std::vector<std::string> line = {find_python(tool), file, "--softwet", self};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : line) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  throw Error(Exit::machine_failed, fmt::format("{}: cannot start '{}': {}", tool.name, line[0], std::strerror(errno)));
}

}  // namespace softwet
