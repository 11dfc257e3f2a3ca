// Making, guarding and removing the output folder.
#include "app/host/output_folder.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/error.hpp"
#include "app/host/case_file.hpp"

namespace softwet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& path, const std::string& reason) {
  throw Error(Exit::machine_failed,
              fmt::format("cannot write to '{}': {}; choose another folder with --out", path, reason));
}

/// The files softwet writes, and nothing else a user may keep there.
void remove_old_result(const fs::path& folder) {
  std::error_code error;
  for (const char* name : {"case.toml", "run.json", "history.csv", "interface.csv", "checkpoint.h5", "fields"}) {
    fs::remove_all(folder / name, error);
    if (error) fail_to_write((folder / name).string(), error.message());
  }
}

void write_resolved(const fs::path& folder, const Case& c) {
  const fs::path path = folder / "case.toml";
  std::ofstream file(path);
  file << "# Resolved case: every key with the value of this run.\n" << write_case(c);
  file.close();
  if (!file) fail_to_write(path.string(), "the disk is full or the folder is not yours");
}

void check_old_result(const fs::path& folder, OldResult old) {
  if (old == OldResult::resume && !fs::exists(folder / "checkpoint.h5")) {
    throw Error(Exit::invalid_input,
                fmt::format("--resume: there is no checkpoint.h5 in '{}'; leave out --resume to start "
                            "from the beginning, or give the folder with --out",
                            folder.string()));
  }
  if (old == OldResult::refuse && (fs::exists(folder / "history.csv") || fs::exists(folder / "checkpoint.h5"))) {
    throw Error(Exit::invalid_input, fmt::format("the folder '{}' holds the result of an earlier run; continue it with "
                                                 "--resume, replace it with --overwrite, or choose another with --out",
                                                 folder.string()));
  }
}

/// The topmost folder of the path that does not exist yet.
fs::path first_missing(const fs::path& folder) {
  fs::path missing;
  for (fs::path part = fs::absolute(folder).lexically_normal(); !fs::exists(part); part = part.parent_path()) {
    missing = part;
    if (part == part.parent_path()) break;
  }
  return missing;
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path, const Case& c, OldResult old) : path_(path), case_(c), old_(old) {
  const fs::path folder(path);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) fail_to_write(path, "a file has that name");
  check_old_result(folder, old);
  if (old != OldResult::resume) {
    made_ = first_missing(folder).string();
    fs::create_directories(folder, error);
    if (error) fail_to_write(path, error.message());
    if (::access(path.c_str(), W_OK | X_OK) != 0) fail_to_write(path, std::strerror(errno));
  }
  lock();
}

OutputFolder::~OutputFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFolder::lock() {
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // File systems without locks go unguarded.
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  throw Error(Exit::invalid_input, fmt::format("another run is writing to '{}'; wait for its end, or choose another "
                                               "folder with --out",
                                               path_));
}

void OutputFolder::begin() {
  begun_ = true;
  if (old_ == OldResult::overwrite) remove_old_result(path_);
  write_resolved(path_, case_);
}

void OutputFolder::discard() {
  std::error_code error;
  if (begun_ && fs::exists(fs::path(path_) / "history.csv", error)) return;
  if (begun_) fs::remove(fs::path(path_) / "case.toml", error);
  if (made_.empty()) return;
  // Only empty folders go, from the deepest one up to the topmost one made here.
  for (fs::path part = fs::absolute(path_).lexically_normal(); fs::remove(part, error); part = part.parent_path()) {
    if (part == fs::path(made_)) break;
  }
}

}  // namespace softwet
