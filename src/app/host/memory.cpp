#include "app/host/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "app/error.hpp"

namespace softwet {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number behind "Name:" in a file such as /proc/meminfo, in KiB; `missing` where there is none.
double kib_of(const char* path, const std::string& name, double missing) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(name + ":", 0) != 0) continue;
    double kib = 0;
    return std::istringstream(line.substr(name.size() + 1)) >> kib ? kib : missing;
  }
  return missing;
}

/// The one number of a file; "max" and a missing file are no limit.
double number_in(const char* path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? number : unlimited;
}

/// What the control group of a container or a job leaves; version 2 (Linux).
double left_by_control_group() {
  const double limit = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
  return limit == unlimited || used == unlimited ? unlimited : std::max(0.0, limit - used);
}

double left_by_process_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - 1024 * kib_of("/proc/self/status", "VmSize", 0));
}

}  // namespace

double most_unknowns(const Case& c) {
  double points = 1;
  for (int elements : c.domain.elements) points *= elements + 2.0 * c.domain.degree;
  return points * (c.dimension() + (c.fluid ? 2 : 0));
}

double least_bytes(const Case& c) {
  double points = 1;
  for (int elements : c.domain.elements) points *= elements;
  const double solid = !c.substrate ? 0 : c.fluid ? c.substrate->thickness / c.domain.size.back() : 1;
  const double velocity = points * c.dimension(), unknowns = velocity + 2 * points * (1 - solid);
  const double vectors = 2.0 * c.solver.krylov_restart + 13;  // Krylov; Newton 5, states 4, stage 2, residual and work
  return 8 * (vectors * unknowns + 2 * velocity);
}

double bytes_to_be_had() {
  const double system = 1024 * kib_of("/proc/meminfo", "MemAvailable", unlimited);
  const double held = 1024 * kib_of("/proc/self/status", "VmRSS", 0);
  return held + std::min({system, left_by_control_group(), left_by_process_limit()});
}

void require_bytes(const Case& c, double needed) {
  const double available = bytes_to_be_had();
  if (needed <= available) return;
  std::string mesh;
  for (int elements : c.domain.elements) mesh += (mesh.empty() ? "" : ", ") + std::to_string(elements);
  throw Error(
      Exit::machine_failed,
      fmt::format("the case needs {} of memory or more, and {} can be had here (domain.elements = [{}], "
                  "solver.krylov.restart = {}, solver.krylov.preconditioner = \"{}\"); take fewer elements, a "
                  "smaller restart, the preconditioner \"schwarz\", or a machine with more memory",
                  bytes_text(needed), bytes_text(available), mesh, c.solver.krylov_restart, c.solver.preconditioner));
}

std::string bytes_text(double bytes) {
  constexpr double mebi = 1048576, gibi = 1024 * mebi;
  return bytes < gibi ? fmt::format("{:.1f} MiB", bytes / mebi) : fmt::format("{:.4g} GiB", bytes / gibi);
}

}  // namespace softwet
