#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "case/error.hpp"

namespace softwet {
namespace {

std::string remedy_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free space on that disk, or raise the quota";
    case EFBIG:
      return "raise the limit of the size of a file (ulimit -f)";
    case EACCES:
    case EPERM:
    case EROFS:
      return "make the folder writable";
    default:
      return "check the disk and its folder";
  }
}

/// What holds for a run that begins and for one that goes on.
const char* const elsewhere = ", or give a folder on another disk with --out (to resume: a copy of this one)";

/// fsync of a file or folder by name.
void make_durable(const std::string& path, int open_flags) {
  const int descriptor = ::open(path.c_str(), open_flags | O_CLOEXEC);
  if (descriptor < 0) throw_disk_error(path, "cannot be opened to bring it to the disk", errno);
  const int failed = ::fsync(descriptor) != 0 ? errno : 0;
  ::close(descriptor);
  // Some network and in-memory file systems do not know fsync: nothing more can be done there.
  if (failed != 0 && failed != EINVAL && failed != ENOTSUP) throw_disk_error(path, "did not reach the disk", failed);
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

void throw_disk_error(const std::string& path, const std::string& what, int error_number) {
  throw Error(Exit::machine_failed,
              path + ": " + what + ": " + std::strerror(error_number) + "; " + remedy_of(error_number) + elsewhere);
}

AtomicFile::AtomicFile(const std::string& path, Folder folder) : path_(path), partial_path_(path + ".partial") {
  std::error_code error;
  if (folder == Folder::made) std::filesystem::create_directories(folder_of(path), error);
  if (error) throw_disk_error(folder_of(path), "the folder cannot be made", error.value());
  ::unlink(partial_path_.c_str());  // left by a run that was killed, or a pipe that would be waited for
}

AtomicFile::~AtomicFile() {
  if (!committed_) ::unlink(partial_path_.c_str());
}

void AtomicFile::commit() {
  make_durable(partial_path_, O_RDONLY);
  if (std::rename(partial_path_.c_str(), path_.c_str()) != 0) {
    throw_disk_error(path_, "cannot be replaced by its new version", errno);
  }
  committed_ = true;
  make_durable(folder_of(path_), O_RDONLY | O_DIRECTORY);
}

void write_text_atomically(const std::string& path, const std::string& text, AtomicFile::Folder folder) {
  AtomicFile target(path, folder);
  std::FILE* file = std::fopen(target.partial_path().c_str(), "wb");
  if (file == nullptr) throw_disk_error(target.partial_path(), "cannot be written", errno);
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const int error_number = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) throw_disk_error(path, "cannot be written", written ? errno : error_number);
  target.commit();
}

}  // namespace softwet
