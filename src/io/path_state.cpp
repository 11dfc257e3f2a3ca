#include "io/path_state.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

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

std::string too_long(const std::string& path, std::size_t room) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  fs::path there = whole.parent_path();  // the folder that exists has the limits of its file system
  while (there.has_relative_path() && !fs::exists(there, error)) there = there.parent_path();
  const auto limit = [&](int name, std::size_t usual) {
    const long found = ::pathconf(there.c_str(), name);
    return found > 0 ? static_cast<std::size_t>(found) : usual;
  };
  const std::size_t of_name = limit(_PC_NAME_MAX, 255), of_path = limit(_PC_PATH_MAX, 4096);
  for (const fs::path& part : whole)
    if (part.native().size() > of_name)
      return "a name in it has " + std::to_string(part.native().size()) + " bytes, and names may have " +
             std::to_string(of_name) + " at most";
  if (whole.native().size() + room < of_path) return "";
  return "it has " + std::to_string(whole.native().size()) + " bytes, and a path may have " +
         std::to_string(of_path - room - 1) + " at most";
}

}  // namespace softwet
