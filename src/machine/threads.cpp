#include "machine/threads.hpp"

#include <fmt/core.h>
#include <strings.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

#include "case/error.hpp"
#include "machine/control_groups.hpp"

namespace softwet {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Cores of one group: quota / period. "max", -1 and a missing file mean no limit.
double cores_in_group(const std::string& folder, GroupVersion version) {
  double quota = 0, period = 0;
  if (version == GroupVersion::two) {
    std::ifstream file(folder + "/cpu.max");
    if (!(file >> quota >> period)) return no_limit;
  } else {
    std::ifstream of_quota(folder + "/cpu.cfs_quota_us"), of_period(folder + "/cpu.cfs_period_us");
    if (!(of_quota >> quota) || !(of_period >> period)) return no_limit;
  }
  return quota > 0 && period > 0 ? quota / period : no_limit;
}

/// The value of a variable of the environment.
std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& wanted) {
  throw Error(Exit::invalid_input,
              fmt::format("{} = '{}' in the environment: must be {}; correct or unset it", name, value, wanted));
}

/// A whole number and nothing else.
std::optional<long> whole_number(const std::string& text) {
  long number = 0;
  const char *begin = text.data(), *end = begin + text.size();
  const auto [stop, status] = std::from_chars(begin, end, number);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// The number of threads that a variable asks for; 0 where it is not set or empty.
int threads_of(const char* name) {
  const auto value = variable(name);
  if (!value || value->empty()) return 0;
  const std::string first = value->substr(0, value->find(','));  // OMP_NUM_THREADS has one for each level of nesting
  const auto number = whole_number(first);
  if (!number || *number < 1 || *number > most_threads)
    refuse(name, *value, fmt::format("a number of threads in [1, {}]", most_threads));
  return static_cast<int>(*number);
}

/// OMP_THREAD_LIMIT: OpenMP starts no more threads, whoever asks for them.
int thread_limit() {
  const auto value = variable("OMP_THREAD_LIMIT");
  const auto number = value ? whole_number(*value) : std::nullopt;  // OpenMP itself complains where it is none
  return number && *number > 0 ? static_cast<int>(std::min<long>(*number, most_threads)) : most_threads;
}

void check_choice(const char* name, const std::vector<const char*>& choices, const std::string& wanted) {
  const auto value = variable(name);
  if (!value) return;
  for (const char* choice : choices)
    if (::strcasecmp(value->c_str(), choice) == 0) return;
  refuse(name, *value, wanted);
}

}  // namespace

double cores_by_control_groups(const std::string& root) { return least_of_groups(root, "cpu", cores_in_group); }

int number_of_threads(int asked, int cores, const std::string& root) {
  const int limit = thread_limit();
  const char* variable_name = threads_of("KOKKOS_NUM_THREADS") > 0 ? "KOKKOS_NUM_THREADS" : "OMP_NUM_THREADS";
  const char* name = asked > 0 ? "--threads" : variable_name;
  const int wanted = asked > 0 ? asked : threads_of(name);
  if (wanted > limit)
    throw Error(Exit::invalid_input, fmt::format("{} = {}: must be at most {}, {}", name, wanted, limit,
                                                 limit < most_threads ? "which is OMP_THREAD_LIMIT in the environment"
                                                                      : "for which Kokkos has room"));
  if (wanted > 0) return wanted;
  const double granted = std::ceil(cores_by_control_groups(root));  // part of a core is better than none of it
  return std::clamp(static_cast<int>(std::min<double>(granted, cores)), 1, limit);
}

void check_environment_of_kokkos() {
  const auto check_number = [](const char* name, long least, long most) {
    const auto value = variable(name);
    const auto number = value ? whole_number(*value) : least;
    if (!number || *number < least || *number > most)
      refuse(name, *value, fmt::format("a whole number in [{}, {}]", least, most));
  };
  check_number("KOKKOS_NUM_THREADS", 1, most_threads);
  check_number("KOKKOS_DEVICE_ID", 0, 1023);
  for (const char* name : {"KOKKOS_DISABLE_WARNINGS", "KOKKOS_PRINT_CONFIGURATION", "KOKKOS_TUNE_INTERNALS"})
    check_choice(name, {"yes", "true", "1", "no", "false", "0"}, "yes or no");
  check_choice("KOKKOS_MAP_DEVICE_ID_BY", {"mpi_rank", "random"}, "mpi_rank or random");
  const auto tool = variable("KOKKOS_TOOLS_LIBS"), older = variable("KOKKOS_PROFILE_LIBRARY");
  if (tool && older && *tool != *older)
    refuse("KOKKOS_PROFILE_LIBRARY", *older, "the same as KOKKOS_TOOLS_LIBS = '" + *tool + "'");
}

}  // namespace softwet
