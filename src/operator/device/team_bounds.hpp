// How many teams of a kernel share a multiprocessor of a device. Only this and the sizes of tiles depend on the
// machine.
#pragma once

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace softwet {

/// A multiprocessor: bytes of the memory that its teams share, threads, and threads of a warp.
struct Multiprocessor {
  int bytes, threads, warp;
};

// The CUDA programming guide, table of the compute capabilities; AMD's documents of the MI200 and MI300 series.
#if defined(KOKKOS_ENABLE_HIP)
inline constexpr Multiprocessor multiprocessor{64 * 1024, 2048, 64};
#elif defined(KOKKOS_ARCH_VOLTA70) || defined(KOKKOS_ARCH_VOLTA72)
inline constexpr Multiprocessor multiprocessor{96 * 1024, 2048, 32};
#elif defined(KOKKOS_ARCH_TURING75)
inline constexpr Multiprocessor multiprocessor{64 * 1024, 1024, 32};
#elif defined(KOKKOS_ARCH_AMPERE80)
inline constexpr Multiprocessor multiprocessor{164 * 1024, 2048, 32};
#elif defined(KOKKOS_ARCH_AMPERE87)
inline constexpr Multiprocessor multiprocessor{164 * 1024, 1536, 32};
#elif defined(KOKKOS_ARCH_AMPERE86) || defined(KOKKOS_ARCH_ADA89) || defined(KOKKOS_ARCH_BLACKWELL120)
inline constexpr Multiprocessor multiprocessor{100 * 1024, 1536, 32};
#else  // Hopper and Blackwell
inline constexpr Multiprocessor multiprocessor{228 * 1024, 2048, 32};
#endif

constexpr int warps_of(int threads) { return (threads + multiprocessor.warp - 1) / multiprocessor.warp; }

/// How many teams with so many threads and bytes of scratch fit; 0: a device does not give a team so much. Kokkos keeps
/// a number for each thread of a team and some more, and a chip one kilobyte for each team.
constexpr int teams_that_fit(int threads, int scratch) {
  const int bytes = scratch + (threads + 4) * 8;
  if (bytes > 48 * 1024) return 0;
  const int whole_warps = warps_of(threads) * multiprocessor.warp;
  return std::min(multiprocessor.bytes / (bytes + 1024), multiprocessor.threads / whole_warps);
}

/// The second number of launch bounds: teams on a multiprocessor. The compiler for AMD takes it as warps on each of the
/// four units of a multiprocessor.
constexpr int second_bound([[maybe_unused]] int threads, int teams) {
#if defined(KOKKOS_ENABLE_HIP)
  return (teams * warps_of(threads) + 3) / 4;
#else
  return teams;
#endif
}

template <int threads, int scratch, int wanted>
struct BoundsOfTeams {
  static constexpr int teams = std::min(wanted, teams_that_fit(threads, scratch));
  static_assert(teams > 0, "a device may give a team 48 kB and no more");
  using type = Kokkos::LaunchBounds<threads, second_bound(threads, teams)>;
};

/// The launch bounds of such teams: as many as wanted on a multiprocessor, or as fit. Kokkos starts no kernel whose
/// bounds ask for more.
template <int threads, int scratch, int wanted>
using TeamBounds = typename BoundsOfTeams<threads, scratch, wanted>::type;

}  // namespace softwet
