// Sums of items, each of some lines of a strip: how a processor and how a device adds them up, to the same bits.
#pragma once

#include <cstdint>

#include "memory/start_teams.hpp"
#include "spline/columns.hpp"

namespace softwet {

/// An item has one sum for each column of a strip and for even and for odd lines. They are added up side by side, on a
/// processor by one thread in vector registers, and then to each other in one fixed order.
inline constexpr int sum_lanes = 2 * strip_width;
static_assert(sum_lanes == 8);
KOKKOS_FORCEINLINE_FUNCTION double sum_of_lanes(const double* sum) {
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

/// One of the sums of an item, which a thread of a device adds up.
struct OneLane {
  int lane;
  double sum = 0;
  KOKKOS_FORCEINLINE_FUNCTION int column() const { return lane % strip_width; }
  KOKKOS_FORCEINLINE_FUNCTION int first_line() const { return lane / strip_width; }
};

/// On a processor. kernel.add(item, sum) adds what an item has, to double[sum_lanes] or to OneLane.
template <class Kernel>
struct ItemSums {
  Kernel kernel;
  Array partial;  ///< [item]
  KOKKOS_FUNCTION void operator()(int item) const {
    double sum[sum_lanes] = {};
    kernel.add(item, sum);
    partial(item) = sum_of_lanes(sum);
  }
};

/// On a device: the threads of a team have a lane each, of items that follow each other.
template <class Kernel>
struct LaneSums {
  static constexpr int items_of_team = 8, lanes_of_team = items_of_team * sum_lanes;
  static constexpr int bytes = lanes_of_team * sizeof(double);
  Kernel kernel;
  int items;
  Array partial;

  void start(const char* name, int threads = team_size(lanes_of_team)) const {
    SmallTeams<lanes_of_team> policy(chunks_in(items, items_of_team), threads);
    start_teams(name, policy.set_scratch_size(0, Kokkos::PerTeam(bytes)), *this);
  }
  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& team) const {
    constexpr std::size_t scratch = bytes;
    double* const sum = static_cast<double*>(team.team_shmem().get_shmem(scratch));
    const int first = team.league_rank() * items_of_team;
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, lanes_of_team), [&](int i) {
      const int item = first + i / sum_lanes;
      OneLane lane{i % sum_lanes};
      if (item < items) kernel.add(item, lane);
      sum[i] = lane.sum;
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, items_of_team), [&](int i) {
      if (first + i < items) partial(first + i) = sum_of_lanes(sum + i * sum_lanes);
    });
  }
};

/// Starts the kernel of the sums of some items.
template <class Kernel>
void start_sums(const char* name, const Kernel& kernel, int items, const Array& partial) {
  if (items == 0) return;
  if constexpr (host_algorithms) {
    Kokkos::parallel_for(name, Items(0, items), ItemSums<Kernel>{kernel, partial});
  } else {
    LaneSums<Kernel>{kernel, items, partial}.start(name);
  }
}

/// total(r) is the sum of partial(b totals + r) over all blocks b, in their order. A team has one r: its threads fetch
/// the numbers of many blocks at once, and one of them adds these up.
struct AddBlocks {
  static constexpr int at_once = 512, bytes = at_once * sizeof(double);
  ConstArray partial;
  int blocks;
  Array total;

  void start(int threads = team_size(64)) const {
    if (total.extent(0) == 0) return;
    Teams<> policy(static_cast<int>(total.extent(0)), threads);
    start_teams("softwet::add_blocks", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)), *this);
  }
  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& team) const {
    constexpr std::size_t scratch = bytes;
    double* const fetched = static_cast<double*>(team.team_shmem().get_shmem(scratch));
    const int r = team.league_rank(), totals = static_cast<int>(total.extent(0));
    double sum = 0;
    for (int first = 0; first < blocks; first += at_once) {
      const int count = blocks - first < at_once ? blocks - first : at_once;
      Kokkos::parallel_for(Kokkos::TeamThreadRange(team, count),
                           [&](int b) { fetched[b] = partial(std::int64_t(first + b) * totals + r); });
      team.team_barrier();
      if (team.team_rank() == 0)
        for (int b = 0; b < count; ++b) sum += fetched[b];
      team.team_barrier();
    }
    if (team.team_rank() == 0) total(r) = sum;
  }
};

}  // namespace softwet
