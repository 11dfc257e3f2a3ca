// How many teams of a kernel share a multiprocessor of a device. Beside the sizes of tiles this is all that is known of machines.
#pragma once

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace softwet {

/// A multiprocessor: bytes of the memory that its teams share, and threads.
struct Multiprocessor {
  int bytes, threads;
};

// The CUDA programming guide, table of the compute capabilities.
#if defined(KOKKOS_ARCH_VOLTA70) || defined(KOKKOS_ARCH_VOLTA72)
inline constexpr Multiprocessor multiprocessor{96 * 1024, 2048};
#elif defined(KOKKOS_ARCH_TURING75)
inline constexpr Multiprocessor multiprocessor{64 * 1024, 1024};
#elif defined(KOKKOS_ARCH_AMPERE80)
inline constexpr Multiprocessor multiprocessor{164 * 1024, 2048};
#elif defined(KOKKOS_ARCH_AMPERE87)
inline constexpr Multiprocessor multiprocessor{164 * 1024, 1536};
#elif defined(KOKKOS_ARCH_AMPERE86) || defined(KOKKOS_ARCH_ADA89) || defined(KOKKOS_ARCH_BLACKWELL120)
inline constexpr Multiprocessor multiprocessor{100 * 1024, 1536};
#else  // Hopper and Blackwell; AMD's read a bound as waves of a unit, which their memory does not limit
inline constexpr Multiprocessor multiprocessor{228 * 1024, 2048};
#endif

/// How many teams with so many threads and bytes of scratch fit; 0: a device does not give a team so much. Kokkos keeps a number
/// for each thread of a team and some more, and a chip one kilobyte for each team.
constexpr int teams_that_fit(int threads, int scratch) {
  const int bytes = scratch + (threads + 4) * 8, whole_warps = (threads + 31) / 32 * 32;
  if (bytes > 48 * 1024) return 0;
  return std::min(multiprocessor.bytes / (bytes + 1024), multiprocessor.threads / whole_warps);
}

template <int threads, int scratch, int wanted>
struct BoundsOfTeams {
  static constexpr int teams = std::min(wanted, teams_that_fit(threads, scratch));
  static_assert(teams > 0, "a device may give a team 48 kB and no more");
  using type = Kokkos::LaunchBounds<threads, teams>;
};

/// The launch bounds of such teams: as many as wanted on a multiprocessor, or as fit. Kokkos starts no kernel whose bounds ask
/// for more.
template <int threads, int scratch, int wanted>
using TeamBounds = typename BoundsOfTeams<threads, scratch, wanted>::type;

}  // namespace softwet
