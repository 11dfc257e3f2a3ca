// The Jacobian of a term on a device: a team of threads makes the matrix of an element in the memory that it shares.
//
// The steps are those of jacobian_batch. Each is cut into items that threads take one by one, and what one step leaves for the
// next lies in the scratch of the team: no thread keeps more than a point or a sum.
#pragma once

#include "operator/matrix_folds.hpp"
#include "operator/tile_team.hpp"

namespace softwet {

/// What the points of an element see: slots, as SeededFields wants them, and the wall below them.
template <int D, int P, int Q, class Term>
struct TeamElement {
  using S = OneNumber<float>;
  using Trial = typename Term::template Trial<Dual<S>, D>;
  static constexpr int QL = points_across<Term, Q>, n = P + 1, wall_points = power(Q, D - 1), points = wall_points * QL;
  static constexpr int slots = Trial::slot_count;

  S (*value)[1 + D][points];  ///< [slot]
  const float* scale;
  float* wall;  ///< [direction][0: displacement, 1..: its slopes] and then [direction] velocity, at the wall's points

  static constexpr int wall_numbers = (D * D + D) * wall_points;
  static constexpr int size = slots * (1 + D) * points + wall_numbers;

  template <class Team, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void load_slots(const Team& team, const TaskType& task, const Batch<D>& b,
                                              const ElementTables<D, P, Q, QL>& table) const {
    const int first = first_control(task.region, b);
    share(team, slots * (1 + D) * points, [&](int item) {
      const int q = item % points, c = item / points % (1 + D), s = item / points / (1 + D);
      const float* p = task.slot[s];
      float sum = 0;
      if (p && (c == 0 ? Trial::slot(s).value : Trial::slot(s).gradient))
        for (int a = 0; a < power(n, D); ++a) {
          int place = first, rest = a, point = q;
          float basis = 1;
          for (int d = 0; d < D; ++d) {
            const int many = d < D - 1 ? Q : QL;
            basis *= table.basis(d, c == 1 + d, point % many, rest % n);
            place += rest % n * task.region.stride[d];
            rest /= n;
            point /= many;
          }
          sum += basis * p[place];
        }
      value[s][c][q] = S(sum);
    });
  }

  /// The motion of the wall and its slopes.
  template <class Team, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void load_wall(const Team& team, const TaskType& task, const Batch<D>& b,
                                             const ElementTables<D, P, Q, QL>& table) const {
    int first = b.element[0];
    if constexpr (D == 3) first += task.region.axis[1].first(b.element[1]) * task.region.stride[1];
    share(team, wall_numbers, [&](int item) {
      const int w = item % wall_points, number = item / wall_points;
      const bool moves = number >= D * D;  // velocity
      const int c = moves ? 0 : number % D;
      const float* p = moves ? task.motion.velocity[number - D * D] : task.motion.displacement[number / D];
      float sum = 0;
      for (int a = 0; a < power(n, D - 1); ++a) {
        float basis = table.basis(0, c == 1, w % Q, a % n);
        if constexpr (D == 3) basis *= table.basis(1, c == 2, w / Q, a / n);
        sum += basis * p[first + a % n + (D == 3 ? a / n * task.region.stride[1] : 0)];
      }
      wall[item] = sum;
    });
  }
};

/// The motion of the wall below a point, as blended_point wants it.
template <int D, int wall_points>
struct TeamWallBelow {
  using S = OneNumber<float>;
  const float* at;
  KOKKOS_FORCEINLINE_FUNCTION S displacement(int i, int c) const { return S(at[(i * D + c) * wall_points]); }
  KOKKOS_FORCEINLINE_FUNCTION S velocity(int i) const { return S(at[(D * D + i) * wall_points]); }
};

/// Geometry at the points of an element, as point_at wants it.
template <int D, int wall_points, class Motion>
struct TeamGeometry {
  using S = OneNumber<float>;
  const Motion& motion;
  const float* wall;

  template <bool face>
  KOKKOS_FORCEINLINE_FUNCTION auto at(int q, const Vector<S, D>& reference, double height) const {
    if constexpr (std::is_same_v<Motion, NoMotion>) {
      return fixed_point<S>(reference);
    } else {
      const TeamWallBelow<D, wall_points> below{wall + q % wall_points};
      return blended_point<S>(motion.blend, motion.scale, reference, height, below, face);
    }
  }
};

template <int D, int P, int Q, class Term, class Motion>
struct TeamJacobian {
  using S = OneNumber<float>;
  using N = Dual<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  using Element = TeamElement<D, P, Q, Term>;
  static constexpr int QL = Element::QL, points = Element::points, channels = Test::channel_count;
  static constexpr int threads = on_host ? 1 : 64;
  using Tables = ElementTables<D, P, Q, QL>;
  using Folds = MatrixFolds<D, P, Q, QL>;

  // Room in the scratch, in numbers.
  static constexpr int tangents =
      (1 + D) * channels * (1 + D) * points;  ///< [trial derivative][channel][test derivative][q]
  static constexpr int flags = channels * (1 + D) * (1 + D);
  static constexpr int size = Tables::size + Element::size + tangents + flags + Folds::size;
  static_assert(size * sizeof(float) <= 47 * 1024, "a device may give a team 48 kB and no more");

  Task<D, Term, Motion, float> task;
  Stencil<D> stencil;
  StencilValues values;
  Colouring<D> colouring;

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    constexpr std::size_t bytes = size * sizeof(float);
    const TileTeam<threads, Member> team{member, 0};
    auto* room = static_cast<float*>(member.team_shmem().get_shmem(bytes));
    const Batch<D> b = colouring.batch(member.league_rank());
    const Tables table{room};
    room += Tables::size;
    const Element element{reinterpret_cast<S(*)[1 + D][points]>(room), task.scale,
                          room + Element::size - Element::wall_numbers};
    room += Element::size;
    table.load(team, task.region, b);
    team.barrier();
    element.load_slots(team, task, b, table);
    if constexpr (!std::is_same_v<Motion, NoMotion>) element.load_wall(team, task, b, table);
    team.barrier();
    for (int u = 0; u < D + 2; ++u)
      if (reads<Trial, D>(u)) columns_of(team, u, b, element, table, room);
  }

  static void launch(const Task<D, Term, Motion, float>& task, const Stencil<D>& stencil, const StencilValues& values) {
    int colours = 1;
    for (int d = 0; d < D; ++d) colours *= Colouring<D>::colours_of(task.region, P + 1, d);
    for (int colour = 0; colour < colours; ++colour)
      for (int run = 0; run < task.region.first_axis().runs; ++run) {
        const Colouring<D> colouring(task.region, P + 1, colour, true, run);
        if (colouring.items() == 0) continue;
        Kokkos::TeamPolicy<Exec, Kokkos::LaunchBounds<64, 6>> policy(colouring.items(), threads);
        Kokkos::parallel_for("softwet::jacobian", policy.set_scratch_size(0, Kokkos::PerTeam(size * sizeof(float))),
                             TeamJacobian{task, stencil, values, colouring});
      }
  }

 private:
  /// The columns of one unknown.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void columns_of(const Team& team, int u, const Batch<D>& b, const Element& element,
                                              const Tables& table, float* room) const {
    float *const tangent = room, *const used = tangent + tangents, *const folds = used + flags;
    share(team, (1 + D) * points, [&](int item) { evaluate(u, item / points, item % points, b, element, tangent); });
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
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int u, int l, int q, const Batch<D>& b, const Element& element,
                                            float* tangent) const {
    auto* out = reinterpret_cast<S(*)[1 + D][points]>(tangent + l * channels * (1 + D) * points);
    for (int c = 0; c < channels; ++c)
      for (int k = 0; k <= D; ++k) out[c][k][q] = S(0.0);
    const TeamGeometry<D, Element::wall_points, Motion> geometry{task.motion, element.wall};
    const auto plain = point_at<Term, Q, S>(geometry, task.region, b, q);
    using Point = FrozenPoint<N, D, std::remove_const_t<decltype(plain)>>;
    const Point point{plain};
    using Seeded = SeededFields<Element, N, Trial, D>;
    const Seeded seeded{element, u, l};
    const Test test = task.term.residual(Trial::read(Reader<N, D, Seeded, Point>{seeded, point, q}));
    const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
    test.write(Writer<S, N, D, points, Point>{out, point, weight, q});
  }
};

}  // namespace softwet
