#include "machine/control_groups.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

namespace softwet {
namespace {

using OfFolder = std::function<double(const std::string& folder, GroupVersion)>;

/// The least of a group and all groups above it. A container may see its own group at `mount` only.
double least_along(const std::string& mount, std::string path, const OfFolder& of_folder, GroupVersion version) {
  double least = std::numeric_limits<double>::infinity();
  for (;;) {
    least = std::min(least, of_folder(mount + path, version));
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return least;
    path.resize(slash);
  }
}

}  // namespace

double least_of_groups(const std::string& root, const std::string& controller, const OfFolder& of_folder) {
  const std::string mount = root + "/sys/fs/cgroup";
  std::ifstream file(root + "/proc/self/cgroup");
  double least = std::numeric_limits<double>::infinity();
  for (std::string line; std::getline(file, line);) {  // number:controllers:path
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string path = line.substr(second + 1);
    if (controllers == ",,") least = std::min(least, least_along(mount, path, of_folder, GroupVersion::two));
    if (controllers.find("," + controller + ",") != std::string::npos)
      least = std::min(least, least_along(mount + "/" + controller, path, of_folder, GroupVersion::one));
  }
  return least;
}

}  // namespace softwet
