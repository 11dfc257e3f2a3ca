// How many threads a computation has: what the user says, or as many as it may have cores.
#pragma once

#include <string>

namespace softwet {

/// The OpenMP backend of Kokkos keeps its threads in an array of this length.
constexpr int most_threads = 512;

/// Cores that the control groups of this process (a container, a job) and those above them grant it: the quota over
/// the period, cpu.max of version 2, cpu.cfs_quota_us and cpu.cfs_period_us of version 1. Infinity without a limit.
/// @param root  what stands before /proc and /sys: a folder in tests
double cores_by_control_groups(const std::string& root = "");

/// The number of threads: `asked`, else the value of KOKKOS_NUM_THREADS, else the first value of OMP_NUM_THREADS, else
/// one for each core that the control groups grant, and as many as OMP_THREAD_LIMIT and the backend allow.
/// @param asked  0: nothing  @param cores  of this process
/// Throws Error (invalid_input) naming the option or the variable whose value is not a number of threads.
int number_of_threads(int asked, int cores, const std::string& root = "");

/// Checks the variables that Kokkos reads when it starts, since Kokkos ends the program where it does not understand
/// one. Throws Error (invalid_input) naming the variable, its value and the allowed values.
void check_environment_of_kokkos();

}  // namespace softwet
