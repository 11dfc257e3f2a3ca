// Kernels of the products with the inverses of boxes, and of their weighted sum.
#pragma once

#include <algorithm>

#include "field/range_factors.hpp"
#include "memory/start_teams.hpp"
#include "solver/schwarz/box_inverses.hpp"

namespace softwet {

/// Boxes that are multiplied together by the inverse that they share. On a device two: each entry that is read serves
/// both, and there are still enough teams. What the next pair reads of the same inverse is in the cache, for it is at
/// work then.
inline constexpr int most_together = chunk(8, 2);

/// Lanes of a thread on a device, and threads of a team: as many lanes as there are rows to take.
inline constexpr int box_lanes = team_size(32);
constexpr int box_team(int unknowns) {
  return on_host ? 1 : std::clamp(chunks_in(chunks_in(unknowns, rows_at_once), box_lanes), 1, 8);
}

/// What a launch of the boxes' products does beside: nothing.
struct NothingBeside {
  int items() const { return 0; }
  KOKKOS_FUNCTION void operator()(int) const {}
};

/// out = W_b A_b^-1 W_b r on every box. A team takes some boxes with one inverse; its lanes (host) or threads (device)
/// take neighbouring rows and walk along the columns together. Further teams do what does not depend on that, item by
/// item.
template <class Real, class Beside>
struct ApplyBoxes {
  using Indices = Kokkos::View<const int*, Exec>;
  Indices size, dof, member, first_member;
  BoxInverses inverses;
  Kokkos::View<const float*, Exec> weight;
  ConstArrayOf<Real> r;
  Kokkos::View<float*, Exec> out;
  int unknowns, teams;
  Beside beside;
  int items;  ///< of what is done beside
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  static constexpr int items_of_team = 256;

  void run() {
    items = beside.items();
    const std::size_t scratch = Scratch::shmem_size(most_together * unknowns);
    const int league = teams + chunks_in(items, items_of_team);
    // registers for what is read ahead
    Teams<Kokkos::LaunchBounds<256, 5>> policy(league, box_team(unknowns), box_lanes);
    start_teams("softwet::schwarz", policy.set_scratch_size(0, Kokkos::PerTeam(scratch)), *this);
  }

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    if (team.league_rank() < teams) return multiply_boxes(team);
    const int first = (team.league_rank() - teams) * items_of_team;
    const int last = first + items_of_team < items ? first + items_of_team : items;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, first, last), [&](int i) { beside(i); });
  }
  KOKKOS_FUNCTION void multiply_boxes(const Team& team) const {
    const int begin = first_member(team.league_rank()), count = first_member(team.league_rank() + 1) - begin;
    const int n = size(member(begin));
    const Scratch local(team.team_scratch(0), most_together * unknowns);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count * n), [&](int i) {
      const int unknown = dof(member(begin + i / n) * unknowns + i % n);
      local(i) = static_cast<float>(r(unknown)) * weight(unknown);
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, chunks_in(n, rows_at_once)), [&](int piece) {
      int k = 0;
      for (; k + 1 < count; k += 2) multiply<2>(&member(begin + k), piece * rows_at_once, n, &local(k * n));
      for (; k < count; ++k) multiply<1>(&member(begin + k), piece * rows_at_once, n, &local(k * n));
    });
  }
  /// Some rows of the answers of boxes that share an inverse.
  template <int count>
  KOKKOS_FORCEINLINE_FUNCTION void multiply(const int* box, int first, int n, const float* local) const {
    const float* x[count];
    for (int k = 0; k < count; ++k) x[k] = local + k * n;
    float sum[count][rows_at_once];
    inverses.multiply(*box, n, first, x, sum);
    for (int k = 0; k < count; ++k)
      for (int i = 0; i < rows_at_once && first + i < n; ++i) out(box[k] * unknowns + first + i) = sum[k][i];
  }
};

/// What the boxes' answers are added to: nothing.
struct NoStart {
  KOKKOS_FUNCTION double operator()(int) const { return 0; }
};

/// z = factors (start + damping times what the boxes say of each unknown). Both vectors may be one.
template <class Start, class Real>
struct CollectBoxes {
  Kokkos::View<const int*, Exec> grouped, place;
  Kokkos::View<const float*, Exec> weight, out;
  Start start;
  float damping;
  RangeFactors factors;
  ArrayOf<Real> z;

  void run() const { Kokkos::parallel_for("softwet::collect", Items(0, z.extent(0)), *this); }
  KOKKOS_FUNCTION void operator()(int i) const {
    float sum = 0;
    for (int k = grouped(i); k < grouped(i + 1); ++k) sum += out(place(k));
    const double all = start(i) + damping * weight(i) * sum;
    z(i) = static_cast<Real>(factors.at(i)) * static_cast<Real>(all);
  }
};

}  // namespace softwet
