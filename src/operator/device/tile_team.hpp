// The threads that share a tile.
#pragma once

#include <Kokkos_Core.hpp>

#include "operator/device/tile_shape.hpp"

namespace softwet {

/// A number as if it had just been read. Else a device compiler computes places once, keeps them over the point
/// functions, and registers run out.
KOKKOS_FORCEINLINE_FUNCTION int anew(int x) {
#if defined(__CUDA_ARCH__)
  asm volatile("" : "+r"(x));
#elif defined(__HIP_DEVICE_COMPILE__)
  asm volatile("" : "+v"(x));
#endif
  return x;
}

/// A pointer likewise, so that a device compiler keeps it where loads need it.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T* anew(T* x) {
#if defined(__CUDA_ARCH__)
  asm volatile("" : "+l"(x));
#endif
  return x;
}

/// i / by and i % by of a number that is not negative, for which a device needs fewer instructions than for one with a
/// sign.
KOKKOS_FORCEINLINE_FUNCTION int quotient(int i, unsigned by) { return static_cast<int>(static_cast<unsigned>(i) / by); }
KOKKOS_FORCEINLINE_FUNCTION int modulo(int i, unsigned by) { return static_cast<int>(static_cast<unsigned>(i) % by); }

/// A number in memory that no thread of the kernel writes, so that a device may read it without waiting for earlier
/// writes.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real constant(const Real* at) {
#if defined(__CUDA_ARCH__)
  return __ldg(at);
#else
  return *at;
#endif
}

/// A team of Kokkos with so many threads: one for each point of a pass on a device, one for all on the host.
template <int threads, class Member>
struct TileTeam {
  static constexpr int size = threads;
  const Member& member;
  int tile_;  ///< number of the tile among the tiles of its term

  KOKKOS_FORCEINLINE_FUNCTION int tile() const { return anew(tile_); }
  KOKKOS_FORCEINLINE_FUNCTION int rank() const { return anew(member.team_rank()); }
  /// A barrier without the question of Kokkos whether a block of a device holds several teams: here it holds one.
  KOKKOS_FORCEINLINE_FUNCTION void barrier() const {
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
    __syncthreads();
#else
    member.team_barrier();
#endif
  }
};

/// The items 0 .. count - 1, shared by the threads of a team.
template <class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share(const Team& team, int count, const Body& body) {
  for (int i = team.rank(); i < count; i += Team::size) body(i);
}

/// Shares a number of items that the compiler knows: no loop where the team has a thread for each, from thread `first`
/// on if possible.
template <int count, int first = 0, class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share_known(const Team& team, const Body& body) {
  if constexpr (count > Team::size) {
    share(team, count, body);
  } else {
    const int i = team.rank() - (first + count <= Team::size ? first : 0);
    if (count == Team::size || (i >= 0 && i < count)) body(i);
  }
}

/// The items 0 .. count - 1 as share gives them, in two steps: read(item, numbers), of all items of a thread where
/// these are few, then write(item, numbers). So a device waits for memory once.
template <int count, class Numbers, class Team, class Read, class Write>
KOKKOS_FORCEINLINE_FUNCTION void share_reads(const Team& team, const Read& read, const Write& write) {
  constexpr int each = (count + Team::size - 1) / Team::size, few = 4;
  if constexpr (each > few) {
    share(team, count, [&](int i) {
      Numbers own;
      read(i, own);
      write(i, own);
    });
  } else {
    Numbers own[each];
    const int rank = team.rank();
    const auto for_own = [&](const auto& body) {
      SOFTWET_UNROLL
      for (int l = 0; l < each; ++l) {
        const int i = rank + l * Team::size;
        if (count >= (l + 1) * Team::size || i < count) body(i, own[l]);
      }
    };
    for_own(read);
    for_own(write);
  }
}

/// Shares the items from thread `first` on, so that other warps take other short lists.
template <class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share_from(const Team& team, int first, int count, const Body& body) {
  const int behind = team.rank() - first % Team::size;
  for (int i = behind < 0 ? behind + Team::size : behind; i < count; i += Team::size) body(i);
}

/// body(point, how many points of this thread came before): the points 0 .. count - 1, shared likewise, `lanes` of them
/// among each 16 threads.
template <int count, int lanes = 16, class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void share_points(const Team& team, const Body& body) {
  constexpr int slots = slots_of(count, lanes), each = (slots + Team::size - 1) / Team::size;
  for (int l = 0; l < each; ++l) {
    const int slot = team.rank() + l * Team::size, lane = modulo(slot, 16);
    if ((slots == each * Team::size || slot < slots) && (lanes == 16 || lane < lanes))
      body(lanes == 16 ? slot : quotient(slot, 16) * lanes + lane, l);
  }
}

}  // namespace softwet
