// Making, guarding and removing the output folder.
#include "run/host/output_folder.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "io/atomic_file.hpp"
#include "io/path_state.hpp"
#include "observe/host/laboratory_units.hpp"

namespace softwet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& path, const std::string& reason) {
  throw Error(Exit::machine_failed,
              fmt::format("cannot write to '{}': {}; make it writable, or give another folder with --out (to resume: a "
                          "copy of this one)",
                          path, reason));
}

/// The files softwet writes, and nothing else a user may keep there.
void remove_old_result(const fs::path& folder) {
  std::error_code error;
  for (const char* name :
       {"case.toml", "run.json", "history.csv", "interface.csv", "checkpoint.h5", "fields", "units.json"}) {
    fs::remove_all(folder / name, error);
    if (error) fail_to_write((folder / name).string(), error.message());
  }
}

void write_resolved(const fs::path& folder, const Case& c, const std::optional<Laboratory>& laboratory) {
  write_text_atomically((folder / "case.toml").string(), "# Resolved case: every key with the value of this run.\n" +
                                                             write_case(c) + (laboratory ? laboratory->table : ""));
  if (laboratory) write_text_atomically((folder / "units.json").string(), units_record(c, laboratory->scales));
}

constexpr std::size_t longest_file = 64;  ///< bytes of names in the folder, "fields/solid_000123.h5.partial"

/// Its beginning and its end, where a path is too long for a message.
std::string ends_of(const std::string& path) {
  return path.size() <= 200 ? path : path.substr(0, 100) + "..." + path.substr(path.size() - 60);
}

[[noreturn]] void refuse(const std::string& message) { throw Error(Exit::invalid_input, message); }

void check_old_result(const fs::path& folder, OldResult old) {
  const std::string name = folder.string();
  const bool has_checkpoint = fs::exists(folder / "checkpoint.h5"), has_rows = fs::exists(folder / "history.csv");
  if (has_rows && !has_checkpoint && old == OldResult::resume)
    refuse(
        fmt::format("--resume: the run in '{}' ended before its first checkpoint, so there is no state to go on from; "
                    "start it again from the beginning with --overwrite in place of --resume",
                    name));
  if (has_rows && !has_checkpoint && old == OldResult::refuse)
    refuse(
        fmt::format("the folder '{}' holds a run that ended before its first checkpoint; start it again from the "
                    "beginning with --overwrite, or choose another folder with --out",
                    name));
  if (!has_checkpoint && old == OldResult::resume)
    refuse(
        fmt::format("--resume: there is no run in '{}'; leave out --resume to start one, or give the folder of the "
                    "run with --out",
                    name));
  if (has_checkpoint && old == OldResult::refuse)
    refuse(
        fmt::format("the folder '{}' holds the result of an earlier run; continue it with --resume, replace it with "
                    "--overwrite, or choose another with --out",
                    name));
}

/// " (process 1234)" for the holder of the lock on an open folder, as Linux gives it; empty where it does not.
std::string holder_text(int descriptor) {
  struct stat folder {};
  if (::fstat(descriptor, &folder) != 0) return "";
  const std::string place = fmt::format("{:02x}:{:02x}:{}", major(folder.st_dev), minor(folder.st_dev), folder.st_ino);
  std::ifstream locks("/proc/locks");
  // "7: FLOCK  ADVISORY  WRITE 1234 08:01:5678 0 EOF"
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, manner, access, where;
    long process = 0;
    if (words >> number >> kind >> manner >> access >> process >> where && kind == "FLOCK" && where == place &&
        process > 0)
      return fmt::format(" (process {})", process);
  }
  return "";
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

OutputFolder::OutputFolder(const std::string& path, const Case& c, OldResult old, std::optional<Laboratory> laboratory)
    : path_(path), case_(c), old_(old), laboratory_(std::move(laboratory)) {
  const fs::path folder(path);
  std::error_code error;
  if (const std::string problem = too_long(path, longest_file); !problem.empty())
    refuse(fmt::format("the output folder '{}': {}; give a shorter one with --out", ends_of(path), problem));
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) fail_to_write(path, "a file has that name");
  lock();  // first: what a run that is under way has written so far is not a result
  check_old_result(folder, old);
  if (old != OldResult::resume) {
    made_ = first_missing(folder).string();
    fs::create_directories(folder, error);
    if (error) fail_to_write(path, error.message());
  }
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail_to_write(path, std::strerror(errno));
  if (lock_.descriptor < 0) lock();
}

OutputFolder::Lock::~Lock() {
  if (descriptor >= 0) ::close(descriptor);
}

void OutputFolder::lock() {
  lock_.descriptor = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // `softwet status` holds the lock for a moment to see whether it is taken: try again before believing it.
  for (int attempt = 0; attempt < 10; ++attempt) {
    if (attempt > 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    // File systems without locks go unguarded.
    const int descriptor = lock_.descriptor;
    if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  }
  refuse(
      fmt::format("another run{} is writing to '{}' at this moment; wait for its end, or choose another folder with "
                  "--out",
                  holder_text(lock_.descriptor), path_));
}

void OutputFolder::begin() {
  begun_ = true;
  if (old_ == OldResult::overwrite) remove_old_result(path_);
  write_resolved(path_, case_, laboratory_);
}

std::string OutputFolder::place() const {
  if (lock_.descriptor < 0 || leads_to(path_, lock_.descriptor)) return path_;
  std::error_code error;
  const fs::path now = fs::read_symlink(fmt::format("/proc/self/fd/{}", lock_.descriptor), error);
  return !error && leads_to(now.string(), lock_.descriptor) ? now.string() : "";
}

void OutputFolder::discard() {
  if (place() != path_) return;  // what is there now belongs to somebody else
  std::error_code error;
  if (begun_ && fs::exists(fs::path(path_) / "history.csv", error)) return;
  for (const char* name : {"case.toml", "units.json"})
    if (begun_) fs::remove(fs::path(path_) / name, error);
  if (made_.empty()) return;
  // Only empty folders go, from the deepest one up to the topmost one made here.
  for (fs::path part = fs::absolute(path_).lexically_normal(); fs::remove(part, error); part = part.parent_path()) {
    if (part == fs::path(made_)) break;
  }
}

}  // namespace softwet
