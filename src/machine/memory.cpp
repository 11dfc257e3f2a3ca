#include "machine/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "case/error.hpp"
#include "case/mesh.hpp"
#include "case/precision.hpp"
#include "machine/control_groups.hpp"

namespace softwet {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number behind the word `name` at the start of a line, as in /proc/meminfo; `missing` where there is none.
double number_after(const std::string& name, const std::string& path, double missing) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    double number = 0;
    if (words >> first && first == name) return words >> number ? number : missing;
  }
  return missing;
}

/// The one number of a file; "max" and a missing file mean no limit.
double number_in(const std::string& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? number : unlimited;
}

/// Cached files count as used by the group, but the system drops them where memory is asked for.
double left_in_group(const std::string& folder, GroupVersion version) {
  const bool old = version == GroupVersion::one;
  const double limit = number_in(folder + (old ? "/memory.limit_in_bytes" : "/memory.max"));
  const double used = number_in(folder + (old ? "/memory.usage_in_bytes" : "/memory.current"));
  if (limit == unlimited || used == unlimited) return unlimited;
  const std::string stat = folder + "/memory.stat", all = old ? "total_" : "";
  const double cached = number_after(all + "inactive_file", stat, 0) + number_after(all + "active_file", stat, 0);
  return std::clamp(limit - used + cached, 0.0, limit);
}

double left_by_process_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - 1024 * number_after("VmSize:", "/proc/self/status", 0));
}

/// @param memory  the kind of memory, in words
void refuse_above(const Case& c, double needed, double available, const char* memory) {
  if (needed <= available) return;
  std::string mesh;
  for (int d = 0; d < c.dimension(); ++d) mesh += (mesh.empty() ? "" : ", ") + std::to_string(elements_along(c, d));
  throw Error(Exit::machine_failed,
              fmt::format("the case needs {} of {} or more, and {} can be had here (domain.elements = [{}], "
                          "solver.krylov.restart = {}, solver.krylov.preconditioner = \"{}\"); take fewer elements, a "
                          "smaller restart, the preconditioner \"schwarz\", or a machine with more memory",
                          bytes_text(needed), memory, bytes_text(available), mesh, c.solver.krylov_restart,
                          word_of(c.solver.preconditioner)));
}

}  // namespace

double most_unknowns(const Case& c) {
  double points = 1;
  for (int d = 0; d < c.dimension(); ++d) points *= elements_along(c, d) + 2.0 * c.domain.degree;
  return points * (c.dimension() + (c.fluid ? 2 : 0));
}

double least_bytes(const Case& c) {
  double points = 1;
  for (int d = 0; d < c.dimension(); ++d) points *= elements_along(c, d);
  const double solid = c.fluid ? solid_elements(c) / static_cast<double>(elements_along(c, c.dimension() - 1)) : 1;
  const double velocity = points * c.dimension(), unknowns = velocity + 2 * points * (1 - solid);
  const double krylov = (precision_of(c) == Precision::full ? 2.0 : 1.0) * c.solver.krylov_restart;
  const double vectors = krylov + 13;  // Krylov; Newton 5, states 4, stage 2, residual and work
  return 8 * (vectors * unknowns + 2 * velocity);
}

double left_by_control_groups(const std::string& root) { return least_of_groups(root, "memory", left_in_group); }

double bytes_to_be_had() {
  const double system = 1024 * number_after("MemAvailable:", "/proc/meminfo", unlimited);
  const double held = 1024 * number_after("VmRSS:", "/proc/self/status", 0);
  return held + std::min({system, left_by_control_groups(), left_by_process_limit()});
}

void require_bytes(const Case& c, double needed) { refuse_above(c, needed, bytes_to_be_had(), "memory"); }

void require_device_bytes(const Case& c, double needed, double available) {
  refuse_above(c, needed, available, "memory of the device");
}

std::string bytes_text(double bytes) {
  constexpr double mebi = 1048576, gibi = 1024 * mebi;
  return bytes < gibi ? fmt::format("{:.1f} MiB", bytes / mebi) : fmt::format("{:.4g} GiB", bytes / gibi);
}

}  // namespace softwet
