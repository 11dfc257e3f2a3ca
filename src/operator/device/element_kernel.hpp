// A term with reduced quadrature on a device, or one of means over elements: slopes do not follow from the values at the points, so
// that a team sums them for a row of elements.
#pragma once

#include "memory/start_teams.hpp"
#include "operator/device/team_bounds.hpp"
#include "operator/device/team_element.hpp"
#include "operator/device/tile_shape.hpp"

namespace softwet {

/// The residual of a term, or (Tangent) its product, of elements that follow each other. They are a tile of one layer, and what
/// they sum is kept for the tile alone.
template <int P, int Q, bool Tangent, int D, class Term, class Motion, class Real>
struct ElementKernel {
  static constexpr int E = D == 2 ? 8 : 4;
  using Tile = TileShape<D, P, E, 1, 1, 1>;
  using Shape = RowShape<D, P, Q, points_across<Term, Q>, E, Real>;
  using S = typename Shape::S;
  using N = std::conditional_t<Tangent, Dual<S>, S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  using Fields = RowFields<Shape, Trial, Tangent>;
  using Wall = RowWall<Shape, Motion, Tangent>;
  using Tables = RowTables<Shape>;
  static constexpr int points = Shape::all_points, channels = Test::channel_count;
  static constexpr int threads = on_host ? 1 : 32;
  static constexpr int size = Tables::size + Fields::size + Wall::size + channels * (1 + D) * points;
  static constexpr int bytes = size * sizeof(Real);

  Task<D, Term, Motion, Real> task;
  TileGrid<D> grid;
  Real* partial;  ///< [tile][channel][control]

  static void launch(const Task<D, Term, Motion, Real>& task, const TileGrid<D>& grid, Real* partial) {
    Teams<TeamBounds<32, bytes, 12>> policy(grid.count(), threads);
    start_teams("softwet::elements", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)),
                ElementKernel{task, grid, partial});
  }

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t room = bytes;
    run(TileTeam<threads, Member>{member, member.league_rank()},
        static_cast<Real*>(member.team_shmem().get_shmem(room)));
  }

  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, Real* room) const {
    ElementRow<D> row{};
    grid.template corner<Tile>(team.tile(), row.element);
    for (int d = 0; d < D; ++d) row.element[d] += grid.first[d];
    row.low = grid.first[0] + grid.lead;
    row.high = grid.first[0] + grid.elements[0];
    const Tables table{room};
    const Fields fields(room + Tables::size, task.scale);
    const Wall wall{{}, room + Tables::size + Fields::size};
    auto* out = reinterpret_cast<S(*)[1 + D][points]>(wall.wall + Wall::size);
    table.load(team, task.region, row);
    team.barrier();
    fields.load(team, task, row, table);
    wall.load(team, task.motion, task.region, row, table);
    team.barrier();
    share_points<points>(team, [&](int p, int) { evaluate(p, row, fields, wall, out); });
    team.barrier();
    share(team, channels * Tile::controls, [&](int i) {
      partial[std::int64_t(team.tile()) * channels * Tile::controls + i] =
          sum(table, i % Tile::controls, out[i / Tile::controls]);
    });
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int p, const ElementRow<D>& row, const Fields& fields, const Wall& wall,
                                            S (*out)[1 + D][points]) const {
    const int e = p / Shape::points, q = p % Shape::points;
    const Batch<D> b = row.batch(e);
    const RowGeometry<N, Shape, Motion> geometry{task.motion, wall.wall, e};
    const auto point = point_at<Term, Q, S>(geometry, task, b, q);
    using Point = std::remove_const_t<decltype(point)>;
    const Test test = task.term.residual(Trial::read(Reader<N, D, Fields, Point>{fields, point, p}));
    const S weight = S(row.holds(e) ? 1.0 : 0.0) * (task.factor * weight_at<S, D, Q>(task.region, b, q));
    test.write(Writer<S, N, D, points, Point>{out, point, weight, p});
  }

  /// What a control value gets of the integrands against one test function and its slopes.
  KOKKOS_FORCEINLINE_FUNCTION Real sum(const Tables& table, int control, const S (&of)[1 + D][points]) const {
    int at[D], rest = control;
    for (int d = 0; d < D; ++d) {
      at[d] = rest % (Tile::width(d) + P);
      rest /= Tile::width(d) + P;
    }
    Real total = 0;
    for (int e = at[0] > P ? at[0] - P : 0; e < E && e <= at[0]; ++e)
      for (int q = 0; q < Shape::points; ++q)
        for (int c = 0; c <= (Test::has_flux ? D : 0); ++c) {
          int point = q;
          Real basis = 1;
          for (int d = 0; d < D; ++d) {
            const int many = d < D - 1 ? Q : Shape::QL;
            basis *= table.basis(d < D - 1 ? d : D, c == 1 + d, (d == 0 ? e * Q : 0) + point % many,
                                 d == 0 ? at[0] - e : at[d]);
            point /= many;
          }
          total += basis * plain(of[c][e * Shape::points + q]);
        }
    return total;
  }
};

}  // namespace softwet
