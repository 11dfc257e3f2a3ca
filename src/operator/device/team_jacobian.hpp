// The Jacobian of a term on a device: a team of threads makes the matrix of an element in the memory that it shares.
//
// The steps are those of jacobian_batch. Each is cut into items that threads take one by one, and what one step leaves for the
// next lies in the scratch of the team: no thread keeps more than a point or a sum.
#pragma once

#include "memory/start_teams.hpp"
#include "operator/device/matrix_folds.hpp"
#include "operator/device/team_bounds.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

template <int D, int P, int Q, class Term, class Motion>
struct TeamJacobian {
  using Shape = RowShape<D, P, Q, points_across<Term, Q>, 1, float>;
  using S = typename Shape::S;
  using N = Dual<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  using Fields = RowFields<Shape, Trial>;
  using Wall = RowWall<Shape, Motion, false>;
  using Tables = RowTables<Shape>;
  using Folds = MatrixFolds<Shape>;
  static constexpr int points = Shape::points, channels = Test::channel_count;
  static constexpr int threads = team_size(64);

  // Room in the scratch, in numbers.
  static constexpr int tangents =
      (1 + D) * channels * (1 + D) * points;  ///< [trial derivative][channel][test derivative][q]
  static constexpr int flags = channels * (1 + D) * (1 + D);
  static constexpr int size = Tables::size + Fields::size + Wall::size + tangents + flags + Folds::size;
  static constexpr int bytes = size * sizeof(float);

  Task<D, Term, Motion, float> task;
  Stencil<D> stencil;
  StencilValues values;
  Colouring<D> colouring;

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t room = bytes;
    run(TileTeam<threads, Member>{member, member.league_rank()},
        static_cast<float*>(member.team_shmem().get_shmem(room)));
  }

  /// The element of a team is its tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, float* room) const {
    const Batch<D> b = colouring.batch(team.tile());
    const Tables table{room};
    const Fields fields(room + Tables::size, task.scale);
    const Wall wall{{}, room + Tables::size + Fields::size};
    room = wall.wall + Wall::size;
    ElementRow<D> row{};
    for (int d = 0; d < D; ++d) row.element[d] = b.element[d];
    row.low = b.element[0];
    row.high = b.element[0] + 1;
    table.load(team, task.region, row);
    team.barrier();
    fields.load(team, task, row, table);
    wall.load(team, task.motion, task.region, row, table);
    team.barrier();
    for (int u = 0; u < D + 2; ++u)
      if (Fields::reads_unknown(u)) columns_of(team, u, b, fields, wall, table, room);
  }

  static void launch(const Task<D, Term, Motion, float>& task, const Stencil<D>& stencil, const StencilValues& values) {
    Colouring<D>::for_all(task.region, P + 1, FirstAxis::coloured, [&](const Colouring<D>& colouring) {
      Teams<TeamBounds<64, bytes, 6>> policy(colouring.items(), threads);
      start_teams("softwet::jacobian", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)),
                  TeamJacobian{task, stencil, values, colouring});
    });
  }

 private:
  /// The columns of one unknown.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void columns_of(const Team& team, int u, const Batch<D>& b, const Fields& fields,
                                              const Wall& wall, const Tables& table, float* room) const {
    float *const tangent = room, *const used = tangent + tangents, *const folds = used + flags;
    share(team, (1 + D) * points,
          [&](int item) { evaluate(u, item / points, item % points, b, fields, wall, tangent); });
    team.barrier();
    share(team, flags, [&](int i) {
      const int l = i % (1 + D), k = i / (1 + D) % (1 + D), c = i / (1 + D) / (1 + D);
      const float* x = tangent + ((l * channels + c) * (1 + D) + k) * points;
      float any = 0;
      for (int q = 0; q < points; ++q) any = x[q] != 0 ? 1.0f : any;
      used[i] = any;
    });
    team.barrier();
    const int first = first_test(task.region, b);
    for (int c = 0; c < channels; ++c) {
      const int row = Test::channel(c).unknown(D);
      if (!Stencil<D>::couples(row, u)) continue;
      const float* of_channel = tangent + c * (1 + D) * points;
      Folds::run(
          team, table, folds, [&](int k, int l) { return used[(c * (1 + D) + k) * (1 + D) + l] != 0; },
          [&](int k, int l, int q) { return of_channel[(l * channels * (1 + D) + k) * points + q]; },
          [&](int entry, float x) { values(place_of_entry<D, P>(stencil, row, u, first, entry)) += x; });
    }
    team.barrier();
  }

  /// The term at point q with the tangent of derivative l of unknown u: [channel][test derivative][q].
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int u, int l, int q, const Batch<D>& b, const Fields& fields,
                                            const Wall& wall, float* tangent) const {
    auto* out = reinterpret_cast<S(*)[1 + D][points]>(tangent + l * channels * (1 + D) * points);
    for (int c = 0; c < channels; ++c)
      for (int k = 0; k <= D; ++k) out[c][k][q] = S(0.0);
    const RowGeometry<S, Shape, Motion> geometry{task.motion, wall.wall, 0};
    const auto plain = point_at<Term, Q, S>(geometry, task, b, q);
    using Point = FrozenPoint<N, D, std::remove_const_t<decltype(plain)>>;
    const Point point{plain};
    using Seeded = SeededFields<Fields, N, Trial, D>;
    const Seeded seeded{fields, u, l};
    const Test test = task.term.residual(Trial::read(Reader<N, D, Seeded, Point>{seeded, point, q}));
    const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
    test.write(Writer<S, N, D, points, Point>{out, point, weight, q});
  }
};

}  // namespace softwet
