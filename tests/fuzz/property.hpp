// What the fuzz targets share: a property that ends the process with its name where it does not hold.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "case/error.hpp"

namespace softwet {

inline void require_property(bool holds, const std::string& name, const std::string& detail) {
  if (holds) return;
  std::fprintf(stderr, "property broken: %s\n%s\n", name.c_str(), detail.c_str());
  std::abort();
}

/// Runs `work`; the only way out but the end is an Error of bad input whose message has `place` in it, in no more than
/// `lines` lines.
template <class Work>
void only_bad_input(const std::string& place, const Work& work, int lines = 1) {
  try {
    work();
  } catch (const Error& error) {
    const std::string message = error.what();
    require_property(error.code() == Exit::invalid_input, "bad input ends with exit code 1", message);
    require_property(message.find(place) != std::string::npos, "the message names " + place, message);
    require_property(std::count(message.begin(), message.end(), '\n') < lines, "the message is short", message);
  }
}

/// A file name of this process alone, in memory where the system has such a folder. Removed at the end.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& ending) {
    const std::filesystem::path memory = "/dev/shm";
    const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path_ = (folder / ("softwet_fuzz_" + std::to_string(getpid()) + ending)).string();
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace softwet
