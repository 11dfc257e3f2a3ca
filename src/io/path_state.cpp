#include "io/path_state.hpp"

#include <sys/stat.h>

#include <cerrno>

namespace softwet {

bool leads_to(const std::string& path, int descriptor) {
  struct stat open_one {
  }, found{};
  if (::fstat(descriptor, &open_one) != 0) return true;
  if (::stat(path.c_str(), &found) != 0) return errno != ENOENT && errno != ENOTDIR;
  return open_one.st_dev == found.st_dev && open_one.st_ino == found.st_ino;
}

std::string no_regular_file(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0 || S_ISREG(found.st_mode)) return "";
  if (S_ISDIR(found.st_mode)) return "a folder";
  if (S_ISFIFO(found.st_mode)) return "a pipe";
  return S_ISSOCK(found.st_mode) ? "a socket" : "a device";
}

}  // namespace softwet
