// All tiles of an evaluation in one launch, whichever terms they belong to.
//
// The kernel is made for a list of terms. The terms of an evaluation lie behind each other in memory of the device. A team
// finds its own by its number, and runs the code of that term. The terms are copied to the device when they have changed: not
// for each product of a linear solve, because the vector that it multiplies is no part of them.
#pragma once

#include <algorithm>
#include <cstddef>

#include "operator/stored_bytes.hpp"
#include "operator/tile.hpp"

namespace softwet {

/// A term on a mesh with or without motion, as a type.
template <class Term_, class Motion_>
struct TermOnMesh {
  using Term = Term_;
  using Motion = Motion_;
};
template <class... Entries>
struct TermList {
  static constexpr int count = sizeof...(Entries);
  template <class Entry>
  static constexpr bool has = (std::is_same_v<Entry, Entries> || ...);
  template <class Entry>
  static constexpr int place() {
    int i = 0;
    (void)((std::is_same_v<Entry, Entries> || (++i, false)) || ...);
    return i;
  }
};

/// How the elements of a term make tiles. Terms beside the wall have two ways.
enum class TileForm { volume, layer, wall, shared };
template <class Term>
constexpr TileForm form_of(bool shared_test) {
  if (Term::where == Where::wall) return TileForm::wall;
  if (Term::where != Where::beside_wall) return TileForm::volume;
  return shared_test ? TileForm::shared : TileForm::layer;
}
template <TileForm form, class Tile>
using ShapeOf =
    std::conditional_t<form == TileForm::volume, Tile,
                       std::conditional_t<form == TileForm::wall, WallOf<Tile>,
                                          std::conditional_t<form == TileForm::layer, LayerOf<Tile>, SharedOf<Tile>>>>;

inline constexpr int most_sources = 12;

/// The terms of a launch: which code each runs, where it lies, and its first team.
struct TileSchedule {
  int count = 0;
  int code[most_sources] = {}, place[most_sources] = {};
  int first[most_sources + 1] = {};
};

template <class Real>
using TileLaunch = void(const TileSchedule&, const std::byte* terms, const Real* direction);

/// Kernels for the terms of a list, each in the form that it has.
template <class Tile_, bool Tangent, class Real, class List>
struct TileKernel;
template <class Tile_, bool Tangent, class Real, class... Entries>
struct TileKernel<Tile_, Tangent, Real, TermList<Entries...>> {
  template <class Entry, bool shared_test>
  using PlanOf = TilePlan<ShapeOf<form_of<typename Entry::Term>(shared_test), Tile_>, typename Entry::Term,
                          typename Entry::Motion, Tangent, Real>;
  template <class Entry>
  static constexpr int scratch_of = TileScratch<PlanOf<Entry, false>>::size > TileScratch<PlanOf<Entry, true>>::size
                                        ? TileScratch<PlanOf<Entry, false>>::size
                                        : TileScratch<PlanOf<Entry, true>>::size;
  static constexpr int size = std::max({scratch_of<Entries>...}), bytes = size * sizeof(Real);
  static constexpr int threads = on_host ? 1 : Tile_::points;
  static_assert(bytes + (Tile_::points + 4) * sizeof(double) <= 48 * 1024,
                "a device may give a team 48 kB and no more");

  /// Number of the code of a term.
  template <class Entry>
  static constexpr int code(bool shared_test) {
    return 2 * TermList<Entries...>::template place<Entry>() +
           (shared_test && Entry::Term::where == Where::beside_wall ? 1 : 0);
  }

  TileSchedule schedule;
  const std::byte* terms;
  const Real* direction;  ///< that a product multiplies

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t room = bytes;
    auto* scratch = static_cast<Real*>(member.team_shmem().get_shmem(room));
    int s = 0;
    while (member.league_rank() >= schedule.first[s + 1]) ++s;
    const TileTeam<threads, Member> team{member, member.league_rank() - schedule.first[s]};
    (run_if<Entries>(team, s, scratch), ...);
  }

  static void launch(const TileSchedule& schedule, const std::byte* terms, const Real* direction) {
    Kokkos::TeamPolicy<Exec, Kokkos::LaunchBounds<Tile_::points, Tile_::teams>> policy(schedule.first[schedule.count],
                                                                                       threads);
    Kokkos::parallel_for("softwet::tiles", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)),
                         TileKernel{schedule, terms, direction});
  }

 private:
  template <class Entry, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_if(const Team& team, int s, Real* scratch) const {
    if (schedule.code[s] == code<Entry>(false)) return run<PlanOf<Entry, false>>(team, s, scratch);
    if constexpr (Entry::Term::where == Where::beside_wall)
      if (schedule.code[s] == code<Entry>(true)) run<PlanOf<Entry, true>>(team, s, scratch);
  }
  template <class Plan, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, int s, Real* scratch) const {
    reinterpret_cast<const Tile<Plan>*>(terms + schedule.place[s])->run(team, direction, scratch);
  }
};

}  // namespace softwet
