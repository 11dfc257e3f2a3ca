// The Jacobian of a term on a device: a team of threads makes the matrix of a row of elements in the memory that it
// shares.
//
// Each step is cut into items that threads take one by one, and its results for the next step lie in the scratch of the
// team: no thread keeps more than a point or a sum. Neighbouring threads add to entries of neighbouring control points,
// which are neighbours in memory (field/stencil.hpp).
#pragma once

#include "memory/start_teams.hpp"
#include "operator/device/matrix_folds.hpp"
#include "operator/device/team_bounds.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

/// Rows of E elements along the first axis, so far apart that they share no control point. They begin at multiples of E
/// of the whole axis, whichever part of it is stored, so that every sum has the same order.
template <int E, int P>
struct RowsApart {
  static constexpr int colours = 1 + (P + E - 1) / E;
  ElementRun run;
  int first, count;

  RowsApart(const ElementRun& elements, int colour) : run(elements) {
    const int low = (run.begin + run.shift) / E, high = (run.end + run.shift + E - 1) / E;
    first = low + ((colour - low) % colours + colours) % colours;
    count = std::max(0, (high - first + colours - 1) / colours);
  }
  KOKKOS_FORCEINLINE_FUNCTION int begin(int row) const { return (first + colours * row) * E - run.shift; }
};

template <int D, int P, int Q, class Term, class Motion>
struct TeamJacobian {
  static constexpr int QL = points_across<Term, Q>;
  using S = OneNumber<float>;
  using N = Dual<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  static constexpr int channels = Test::channel_count;
  static constexpr int flags_of_channel = (1 + D) * (1 + D), flags = channels * flags_of_channel;

  /// Room in the scratch, in numbers, for so many elements.
  template <int E>
  struct Room {
    using Shape = RowShape<D, P, Q, QL, E, float>;
    using Fields = RowFields<Shape, Trial>;
    using Wall = RowWall<Shape, Motion, false>;
    using Tables = RowTables<Shape>;
    using Folds = MatrixFolds<Shape>;
    static constexpr int points = Shape::all_points;
    static constexpr int tangents =
        (1 + D) * channels * (1 + D) * points;  ///< [trial derivative][channel][test derivative][point]
    static constexpr int size =
        Folds::products + Tables::size + Fields::size + Wall::size + tangents + flags + Folds::size;
  };
  static constexpr int most_threads = 128, threads = team_size(most_threads), alignment = 16;
  template <int E>
  static constexpr bool fits = teams_that_fit(most_threads, Room<E>::size * sizeof(float) + alignment) >= 2;
  static constexpr int E = fits<8> ? 8 : fits<4> ? 4 : fits<2> ? 2 : 1;

  using Shape = typename Room<E>::Shape;
  using Fields = typename Room<E>::Fields;
  using Wall = typename Room<E>::Wall;
  using Tables = typename Room<E>::Tables;
  using Folds = typename Room<E>::Folds;
  using Rows = RowsApart<E, P>;
  static constexpr int offsets_before_last = power(Folds::distances, D - 1);
  static constexpr int points = Shape::all_points, tangents = Room<E>::tangents, size = Room<E>::size;
  static constexpr int bytes = size * sizeof(float);

  Task<D, Term, Motion, float> task;
  Stencil<D> stencil;
  StencilValues values;
  Colouring<D> others;  ///< of the other axes
  Rows rows;

  int items() const { return rows.count * others.items(); }

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t room = bytes;
    run(TileTeam<threads, Member>{member, member.league_rank()},
        static_cast<float*>(member.team_shmem().get_shmem_aligned(room, alignment)));
  }

  /// The row of a team is its tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, float* room) const {
    const ElementRow<D> row = row_of(team.tile());
    auto* const products = reinterpret_cast<typename Folds::Products*>(room);
    const Tables table{room + Folds::products};
    const Fields fields(table.at + Tables::size, task.scale);
    const Wall wall{{}, table.at + Tables::size + Fields::size};
    table.load(team, task.region, row);
    team.barrier();
    fields.load(team, task, row, table);
    wall.load(team, task.motion, task.region, row, table);
    Folds::load(team, table, products);
    team.barrier();
    for (int u = 0; u < D + 2; ++u)
      if (Fields::reads_unknown(u)) columns_of(team, u, row, fields, wall, products, wall.wall + Wall::size);
  }

  static void launch(const Task<D, Term, Motion, float>& task, const Stencil<D>& stencil, const StencilValues& values) {
    Colouring<D>::for_all(task.region, P + 1, FirstAxis::in_rows, [&](const Colouring<D>& others) {
      for (int run = 0; run < others.first_axis.runs; ++run)
        for (int colour = 0; colour < Rows::colours; ++colour) {
          const TeamJacobian kernel{task, stencil, values, others, {others.first_axis.run[run], colour}};
          if (kernel.items() == 0) continue;
          Teams<TeamBounds<most_threads, bytes + alignment, 4>> policy(kernel.items(), threads);
          start_teams("softwet::jacobian", policy.set_scratch_size(0, Kokkos::PerTeam(bytes + alignment)), kernel);
        }
    });
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION ElementRow<D> row_of(int item) const {
    const Batch<D> b = others.batch(item / rows.count);
    ElementRow<D> row{};
    for (int d = 1; d < D; ++d) row.element[d] = b.element[d];
    row.element[0] = rows.begin(item % rows.count);
    row.low = rows.run.begin;
    row.high = rows.run.end;
    return row;
  }

  /// The columns of one unknown.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void columns_of(const Team& team, int u, const ElementRow<D>& row, const Fields& fields,
                                              const Wall& wall, const typename Folds::Products* products,
                                              float* tangent) const {
    float *const used = tangent + tangents, *const folds = used + flags;
    share(team, (1 + D) * points,
          [&](int item) { evaluate(u, item / points, item % points, row, fields, wall, tangent); });
    team.barrier();
    share(team, flags, [&](int i) {
      const int l = i % (1 + D), k = i / (1 + D) % (1 + D), c = i / (1 + D) / (1 + D);
      const float* x = tangent + ((l * channels + c) * (1 + D) + k) * points;
      float any = 0;
      for (int q = 0; q < points; ++q) any = x[q] != 0 ? 1.0f : any;
      used[i] = any;
    });
    team.barrier();
    Batch<D> corner{};
    for (int d = 0; d < D; ++d) corner.element[d] = row.element[d];
    const int first = first_test(task.region, corner), begin = row.low - row.element[0],
              end = row.high - row.element[0];
    const typename Folds::Held held{begin > 0 ? begin : 0, end < E ? end : E};
    for (int c = 0; c < channels; ++c) {
      const int component = Test::channel(c).unknown(D);
      if (!Stencil<D>::couples(component, u) || !any_of(used + c * flags_of_channel)) continue;
      const float* of_channel = tangent + c * (1 + D) * points;
      Folds::run(
          team, products, folds, held,
          [&](int k, int l, int q) { return of_channel[(l * channels * (1 + D) + k) * points + q]; },
          [&](int pair, int middle) { return &values(place(component, u, first, pair, middle)); }, steps());
    }
    team.barrier();
  }

  /// The term at a point with the tangent of derivative l of unknown u: [channel][test derivative][point].
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int u, int l, int p, const ElementRow<D>& row, const Fields& fields,
                                            const Wall& wall, float* tangent) const {
    auto* out = reinterpret_cast<S(*)[1 + D][points]>(tangent + l * channels * (1 + D) * points);
    for (int c = 0; c < channels; ++c)
      for (int k = 0; k <= D; ++k) out[c][k][p] = S(0.0);
    const int e = p / Shape::points, q = p % Shape::points;
    if (!row.holds(e)) return;
    const Batch<D> b = row.batch(e);
    const RowGeometry<S, Shape, Motion> geometry{task.motion, wall.wall, e};
    const auto plain = point_at<Term, Q, S>(geometry, task, b, q);
    using Point = FrozenPoint<N, D, std::remove_const_t<decltype(plain)>>;
    const Point point{plain};
    using Seeded = SeededFields<Fields, N, Trial, D>;
    const Seeded seeded{fields, u, l};
    const Test test = task.term.residual(Trial::read(Reader<N, D, Seeded, Point>{seeded, point, p}));
    const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
    test.write(Writer<S, N, D, points, Point>{out, point, weight, p});
  }

  static KOKKOS_FORCEINLINE_FUNCTION bool any_of(const float* used) {
    float any = 0;
    for (int i = 0; i < flags_of_channel; ++i) any += used[i];
    return any > 0;
  }

  /// Where an entry of the row's matrix is stored, of the functions 0 along the last axis. `first` is the control point
  /// of the row's first test function.
  KOKKOS_FORCEINLINE_FUNCTION std::int64_t place(int component, int u, int first, int pair, int middle) const {
    constexpr int n = P + 1;
    int point = first + pair % Folds::tests, offset = pair / Folds::tests;
    if constexpr (D == 3) {
      point += middle / n * stencil.extent[0];
      offset += (middle % n - middle / n + P) * Folds::distances;
    }
    return stencil.index(component, u, offset + P * offsets_before_last, point);
  }
  KOKKOS_FORCEINLINE_FUNCTION typename Folds::Steps steps() const {
    const std::int64_t trial = std::int64_t(offsets_before_last) * stencil.points;
    return {(D == 3 ? stencil.extent[0] * stencil.extent[1] : stencil.extent[0]) - trial, trial};
  }
};

}  // namespace softwet
