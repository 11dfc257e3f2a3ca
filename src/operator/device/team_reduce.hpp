// Integrals of functionals on a device: a team of threads takes one strip of a row of elements.
#pragma once

#include <algorithm>

#include "memory/start_teams.hpp"
#include "operator/device/team_bounds.hpp"
#include "operator/device/team_element.hpp"
#include "operator/integrate_task.hpp"
#include "operator/rows.hpp"

namespace softwet {

/// Partial sums, as in ReduceRow. The points of an element are summed in their order, and then the elements in theirs.
template <int D, int P, int Q, bool Rate, class Functional, class Motion>
struct TeamReduce {
  static constexpr int E = D == 2 ? strip_width : 1, count = Functional::count;
  using Shape = RowShape<D, P, Q, points_across<Functional, Q>, E, double>;
  using N = std::conditional_t<Rate, Dual<double>, double>;
  using Fields = RowFields<Shape, typename Functional::template Trial<double, D>>;
  using Wall = RowWall<Shape, Motion, Rate>;
  using Tables = RowTables<Shape>;
  static constexpr int points = Shape::all_points;
  static constexpr int threads = team_size(D == 2 ? 64 : 32);
  static constexpr int size = Tables::size + Fields::size + Wall::size + count * (points + E);  ///< of the scratch
  static constexpr int bytes = size * sizeof(double);
  static_assert(teams_that_fit(threads, bytes) > 0, "a device may give a team 48 kB and no more");

  ReduceTask<D, Functional, Motion> task;
  Colouring<D> rows;
  Array partial;  ///< [row][own strip][functional]

  static void launch(const ReduceTask<D, Functional, Motion>& task, const Colouring<D>& rows, const Array& partial,
                     int items) {
    SmallTeams<64> policy(items, threads);
    start_teams("softwet::reduce", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)), TeamReduce{task, rows, partial});
  }

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t scratch = bytes;
    run(TileTeam<threads, Member>{member, member.league_rank()},
        static_cast<double*>(member.team_shmem().get_shmem(scratch)));
  }

  /// The item of a team is its tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, double* room) const {
    const ElementColumns& columns = rows.first_axis;
    const int strips = columns.last_strip - columns.first_strip, strip = team.tile() % strips;
    const int begin = columns.own_begin + strip * strip_width;
    const int end = strip + 1 < strips ? begin + strip_width : columns.own_end;
    const Batch<D> b = rows.batch(team.tile() / strips);
    double* const total = room + size - count * E;
    share(team, count * E, [&](int i) { total[i] = 0; });
    for (int first = begin; first < end; first += E) {
      ElementRow<D> row{};
      for (int d = 0; d < D; ++d) row.element[d] = b.element[d];
      row.element[0] = first;
      row.low = begin;
      row.high = end;
      add_elements(team, row, room, total);
    }
    share(team, count, [&](int f) {
      double sum = 0;
      for (int e = 0; e < E; ++e) sum += total[f * E + e];
      partial(team.tile() * count + f) = sum;
    });
  }

 private:
  /// total[functional][element]
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void add_elements(const Team& team, const ElementRow<D>& row, double* room,
                                                double* total) const {
    const Tables table{room};
    const Fields fields(room + Tables::size, nullptr);
    const Wall wall{{}, room + Tables::size + Fields::size};
    double* const integrand = wall.wall + Wall::size;
    table.load(team, task.region, row);
    team.barrier();
    fields.load(team, task, row, table);
    wall.load(team, task.motion, task.region, row, table);
    team.barrier();
    share(team, points, [&](int p) { evaluate(p, row, fields, wall, integrand); });
    team.barrier();
    share(team, count * E, [&](int i) {
      for (int q = 0; q < Shape::points; ++q) total[i] += integrand[i * Shape::points + q];
    });
    team.barrier();
  }

  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int p, const ElementRow<D>& row, const Fields& values, const Wall& wall,
                                            double* integrand) const {
    using Trial = typename Functional::template Trial<N, D>;
    const int e = p / Shape::points;
    const Batch<D> b = row.batch(e);
    const LiftedFields<Fields, N> fields{values};
    const RowGeometry<N, Shape, Motion> geometry{task.motion, wall.wall, e};
    const auto point = point_at<Functional, Q, double>(geometry, task, b, p % Shape::points);
    const Reader<N, D, LiftedFields<Fields, N>, std::remove_const_t<decltype(point)>> reader{fields, point, p};
    const Vector<N, count> value = task.functional.value(Trial::read(reader));
    const double weight = row.holds(e) ? weight_at<double, D, Q>(task.region, b, p % Shape::points) : 0.0;
    for (int f = 0; f < count; ++f) integrand[f * points + p] = weight * outcome(point.measured(value[f]));
  }
};

/// Two integrals in one launch.
template <class First, class Second>
struct TeamReducePair {
  static constexpr int threads = First::threads, bytes = std::max(First::bytes, Second::bytes);
  static_assert(First::threads == Second::threads, "teams of one launch have the same number of threads");

  First first;
  Second second;
  int of_first;  ///< teams

  void launch(int of_second) const {
    SmallTeams<64> policy(of_first + of_second, threads);
    start_teams("softwet::reduce", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)), *this);
  }

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t scratch = bytes;
    auto* const room = static_cast<double*>(member.team_shmem().get_shmem(scratch));
    const int team = member.league_rank();
    if (team < of_first) {
      first.run(TileTeam<threads, Member>{member, team}, room);
    } else {
      second.run(TileTeam<threads, Member>{member, team - of_first}, room);
    }
  }
};

}  // namespace softwet
