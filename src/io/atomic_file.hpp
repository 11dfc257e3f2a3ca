// A file that appears whole or not at all: written as PATH.partial in the same folder, then renamed.
#pragma once

#include <string>

namespace softwet {

/// Guards the partial file of one output. The content is written by the caller, with any library, to `partial_path()`;
/// `commit()` makes it durable and moves it to its place. Without `commit()` the partial file is removed.
class AtomicFile {
 public:
  /// Whether a missing folder is made. The folder of a run may have been moved, and a new one in its place would hide
  /// that.
  enum class Folder { made, there };

  /// Throws Error (machine_failed) when the folder cannot be made.
  explicit AtomicFile(const std::string& path, Folder folder = Folder::made);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  const std::string& path() const { return path_; }
  const std::string& partial_path() const { return partial_path_; }

  /// fsync, rename, fsync of the folder. The caller has closed the partial file. Throws Error (machine_failed).
  void commit();

 private:
  std::string path_;
  std::string partial_path_;
  bool committed_ = false;
};

/// Writes a text file through AtomicFile. Throws Error (machine_failed).
void write_text_atomically(const std::string& path, const std::string& text,
                           AtomicFile::Folder folder = AtomicFile::Folder::made);

/// Throws Error (machine_failed): what could not be done with which path, the reason of the system, the remedy.
/// @param error_number  errno, taken right after the failure
[[noreturn]] void throw_disk_error(const std::string& path, const std::string& what, int error_number);

}  // namespace softwet
