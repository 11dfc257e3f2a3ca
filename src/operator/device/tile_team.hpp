// The threads that share a tile.
#pragma once

#include <Kokkos_Core.hpp>

namespace softwet {

/// A number as if it had just been read. Else a device compiler computes places once, keeps them over the point functions, and
/// registers run out.
KOKKOS_FORCEINLINE_FUNCTION int anew(int x) {
#if defined(__CUDA_ARCH__)
  asm volatile("" : "+r"(x));
#elif defined(__HIP_DEVICE_COMPILE__)
  asm volatile("" : "+v"(x));
#endif
  return x;
}

/// A team of Kokkos with so many threads: one for each point of a pass on a device, one for all on the host.
template <int threads, class Member>
struct TileTeam {
  static constexpr int size = threads;
  const Member& member;
  int tile_;  ///< among those of its term

  KOKKOS_FORCEINLINE_FUNCTION int tile() const { return anew(tile_); }
  KOKKOS_FORCEINLINE_FUNCTION int rank() const { return anew(member.team_rank()); }
  KOKKOS_FORCEINLINE_FUNCTION void barrier() const { member.team_barrier(); }
};

/// The items 0 .. count - 1, shared by the threads of a team.
template <class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share(const Team& team, int count, const Body& body) {
  for (int i = team.rank(); i < count; i += Team::size) body(i);
}

/// body(point, how many points of this thread came before): the points 0 .. count - 1, shared likewise.
template <int count, class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share_points(const Team& team, const Body& body) {
  constexpr int each = (count + Team::size - 1) / Team::size;
  for (int l = 0; l < each; ++l) {
    const int point = team.rank() + l * Team::size;
    if (count == each * Team::size || point < count) body(point, l);
  }
}

}  // namespace softwet
