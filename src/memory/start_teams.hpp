// How kernels for teams are started.
#pragma once

#include <stdexcept>

#include "memory/chunk.hpp"

namespace softwet {

/// Teams of at most so many threads, and items in blocks of 256, for kernels with many registers. Without such a bound
/// the compiler for AMD leaves registers for 1024 threads; nvcc does not.
#if defined(KOKKOS_ENABLE_HIP)
template <int threads>
using SmallTeams = Teams<Kokkos::LaunchBounds<threads, 1>>;
using SmallBlocks = Kokkos::RangePolicy<Exec, WithLaunch, Kokkos::LaunchBounds<256, 1>>;
#else
template <int threads>
using SmallTeams = Teams<>;
using SmallBlocks = Items;
#endif

/// Starts a kernel for teams. Where a device cannot take such teams, the error names the kernel.
template <class Policy, class Kernel>
void start_teams(const char* name, const Policy& teams, const Kernel& kernel) {
  if constexpr (on_host) {
    Kokkos::parallel_for(name, teams, kernel);
  } else {
    try {
      Kokkos::parallel_for(name, teams, kernel);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(std::string("the device does not start ") + name + " with teams of " +
                               std::to_string(teams.team_size() * teams.impl_vector_length()) + " threads and " +
                               std::to_string(teams.scratch_size(0, teams.team_size())) + " bytes: " + error.what());
    }
  }
}

}  // namespace softwet
