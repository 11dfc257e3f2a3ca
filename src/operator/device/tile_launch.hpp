// The tiles of several terms in one launch.
//
// The kernel is made for a list of terms. The terms of an evaluation lie behind each other in memory of the device. A
// team finds its own by its number, and runs the code of that term. The terms are copied to the device when they have
// changed: not for each product of a linear solve, because the vector that it multiplies is no part of them.
#pragma once

#include <algorithm>
#include <cstddef>

#include "memory/start_teams.hpp"
#include "operator/device/slope_tile.hpp"
#include "operator/device/stored_bytes.hpp"
#include "operator/device/team_bounds.hpp"
#include "operator/device/tile.hpp"

namespace softwet {

/// A term on a mesh with or without motion, as a type; with `shared_test` the elements above each other have the same
/// test functions.
template <class Term_, class Motion_, bool shared_test_ = false>
struct TermOnMesh {
  using Term = Term_;
  using Motion = Motion_;
  static constexpr bool shared_test = shared_test_;
};
template <class... Entries>
struct TermList {
  template <class Entry>
  static constexpr bool has = (std::is_same_v<Entry, Entries> || ...);
  template <class Entry>
  static constexpr int place() {
    int i = 0;
    (void)((std::is_same_v<Entry, Entries> || (++i, false)) || ...);
    return i;
  }
};

/// The shape of the tiles of a term, given the shape for a volume.
template <class Entry, class Tile>
using ShapeOf = std::conditional_t<
    Entry::shared_test, SharedOf<Tile>,
    std::conditional_t<on_face(Entry::Term::where), WallOf<Tile>,
                       std::conditional_t<Entry::Term::where == Where::beside_wall, LayerOf<Tile>, Tile>>>;

inline constexpr int most_sources = 12;

/// The tile of a plan.
template <class Plan>
using TileOf = std::conditional_t<Plan::Shape::own_slopes, SlopeTile<Plan>, Tile<Plan>>;

/// The terms of a launch: the place of each in the list of its kernel, where it lies, and its first team.
struct TileSchedule {
  int count = 0;
  int code[most_sources] = {}, place[most_sources] = {};
  int first[most_sources + 1] = {};
};

template <class Real>
using TileLaunch = void(const TileSchedule&, const std::byte* terms, const Real* direction);

/// The kernel for the terms of a list.
template <class Tile_, bool Tangent, class Real, class List>
struct TileKernel;
template <class Tile_, bool Tangent, class Real, class... Entries>
struct TileKernel<Tile_, Tangent, Real, TermList<Entries...>> {
  template <class Entry>
  using PlanOf = TilePlan<ShapeOf<Entry, Tile_>, typename Entry::Term, typename Entry::Motion, Tangent, Real>;
  static constexpr int size = std::max({TileOf<PlanOf<Entries>>::Room::size...});
  static constexpr int begins_at = 8;  ///< scratch: at a multiple of so many bytes
  static constexpr int wanted_at = Tile_::own_slopes ? 16 : begins_at;
  static constexpr int bytes = size * sizeof(Real) + wanted_at - begins_at;
  static constexpr int threads = Tile_::team(bytes);  ///< of a team on a device

  TileSchedule schedule;
  const std::byte* terms;
  const Real* direction;  ///< that a product multiplies

  template <class Member>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t room = size * sizeof(Real);
    auto* scratch = static_cast<Real*>(wanted_at > begins_at ? member.team_shmem().get_shmem_aligned(room, wanted_at)
                                                             : member.team_shmem().get_shmem(room));
    int s = 0;
    while (member.league_rank() >= schedule.first[s + 1]) ++s;
    const TileTeam<team_size(threads), Member> team{member, member.league_rank() - schedule.first[s]};
    (run_if<Entries>(team, s, scratch), ...);
  }

  static void launch(const TileSchedule& schedule, const std::byte* terms, const Real* direction) {
    constexpr int wanted = Tile_::teams * Tile_::threads / threads;
    Teams<TeamBounds<threads, bytes, wanted>> policy(schedule.first[schedule.count], team_size(threads));
    start_teams("softwet::tiles", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)),
                TileKernel{schedule, terms, direction});
  }

 private:
  template <class Entry, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_if(const Team& team, int s, Real* scratch) const {
    if (schedule.code[s] != TermList<Entries...>::template place<Entry>()) return;
    reinterpret_cast<const TileOf<PlanOf<Entry>>*>(terms + schedule.place[s])->run(team, direction, scratch);
  }
};

}  // namespace softwet
