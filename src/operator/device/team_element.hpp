// Neighbouring elements in the memory that a team of threads of a device shares: their bases, and fields at their
// points.
//
// No thread keeps more than a sum or a point. Matrices and integrals are made of this; terms are computed in tiles
// (tile.hpp, slope_tile.hpp), which need fewer sums.
#pragma once

#include "operator/batch.hpp"
#include "operator/device/tile_team.hpp"
#include "operator/device/wall_below.hpp"

namespace softwet {

/// E elements that follow each other along the first axis from `element` on. Elements outside of [low, high) do not
/// belong to the region; the nearest one is read in their place.
template <int D>
struct ElementRow {
  int element[D], low, high;

  KOKKOS_FORCEINLINE_FUNCTION bool holds(int e) const { return element[0] + e >= low && element[0] + e < high; }
  KOKKOS_FORCEINLINE_FUNCTION Batch<D> batch(int e) const {
    Batch<D> b{};
    for (int d = 0; d < D; ++d) b.element[d] = element[d];
    const int at = element[0] + e;
    b.element[0] = at < low ? low : at < high ? at : high - 1;
    b.count = 1;
    return b;
  }
};

/// How many points E such elements have, of a term with Q points along an axis and QL along the last one.
template <int D_, int P_, int Q_, int QL_, int E_, class Real_>
struct RowShape {
  static constexpr int D = D_, P = P_, Q = Q_, QL = QL_, E = E_, n = P + 1;
  static constexpr int wall_points = power(Q, D - 1), points = wall_points * QL;  ///< of an element
  static constexpr int all_wall_points = E * wall_points, all_points = E * points;
  using Real = Real_;
  using S = OneNumber<Real>;
};

/// Bases of each axis: of the first axis element after element, and of the test functions along the last axis at the
/// end.
template <class Shape>
struct RowTables {
  using Real = typename Shape::Real;
  static constexpr int D = Shape::D, Q = Shape::Q, QL = Shape::QL, n = Shape::n;
  static constexpr int along = Shape::E * Q, most = Q > QL ? Q : QL;  ///< points along the first and along another axis
  static constexpr int first = 2 * along * n, each = 2 * most * n, size = first + D * each;
  Real* at;

  KOKKOS_FORCEINLINE_FUNCTION Real basis(int axis, bool slope, int q, int a) const {
    return axis == 0 ? at[((slope ? along : 0) + q) * n + a]
                     : at[first + (axis - 1) * each + ((slope ? most : 0) + q) * n + a];
  }
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load(const Team& team, const Region<D, Real>& region,
                                        const ElementRow<D>& row) const {
    share(team, first, [&](int i) {
      const int a = i % n, q = i / n % along;
      at[i] = entry(region.axis[0], i / n >= along, q % Q, a, row.batch(q / Q).element[0]);
    });
    share(team, D * each, [&](int i) {
      const int a = i % n, q = i / n % most, axis = 1 + i / each, d = axis < D ? axis : D - 1;
      if (q >= (d < D - 1 ? Q : QL)) return;
      const AxisRuleOf<Real>& rule = axis < D ? region.axis[d] : region.test;
      at[first + i] = entry(rule, i / n / most % 2 == 1, q, a, row.element[d]);
    });
  }

 private:
  static KOKKOS_FORCEINLINE_FUNCTION Real entry(const AxisRuleOf<Real>& rule, bool slope, int q, int a, int e) {
    return slope ? rule.slope(q, a, e) : rule.value(q, a, e);
  }
};

/// The fields of a term at the points, which are numbered element by element. A Task or a ReduceTask says where control
/// values lie.
template <class Shape, class Trial_>
struct RowFields : TrialFields<Trial_, Shape::D, false> {
  using Trial = Trial_;
  using Real = typename Shape::Real;
  using S = typename Shape::S;
  using Names = TrialFields<Trial, Shape::D, false>;
  static constexpr int D = Shape::D, n = Shape::n, points = Shape::all_points;
  static constexpr int size = Names::fields * (1 + D) * points;

  S (*value)[1 + D][points];  ///< [field][0: value, 1..: slopes]
  const Real* scale;          ///< of the slots

  KOKKOS_FORCEINLINE_FUNCTION RowFields(Real* room, const Real* scale_)
      : value(reinterpret_cast<S (*)[1 + D][points]>(room)), scale(scale_) {}

  KOKKOS_FORCEINLINE_FUNCTION S number(int s, int c, int q) const { return value[s][c][q]; }

  template <class Team, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void load(const Team& team, const TaskType& task, const ElementRow<D>& row,
                                        const RowTables<Shape>& table) const {
    for_each_index<Names::fields>([&](auto f) { load_field<f()>(team, task.slot[f()], task.region, row, table); });
  }

 private:
  template <int f, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_field(const Team& team, const Real* from, const Region<D, Real>& region,
                                              const ElementRow<D>& row, const RowTables<Shape>& table) const {
    constexpr int begin = Names::has_value(f) ? 0 : 1, end = Names::has_gradient(f) ? 1 + D : 1;
    constexpr int functions = power(n, D);
    share(team, (end - begin) * points, [&](int item) {
      const int p = item % points, e = p / Shape::points, c = begin + item / points;
      const int first = first_control(region, row.batch(e));
      Real sum = 0;
      for (int a = 0; a < functions && from; ++a) {
        int place = first, rest = a, q = p % Shape::points;
        Real basis = 1;
        for (int d = 0; d < D; ++d) {
          const int many = d < D - 1 ? Shape::Q : Shape::QL;
          basis *= table.basis(d, c == 1 + d, (d == 0 ? e * Shape::Q : 0) + q % many, rest % n);
          place += rest % n * region.stride[d];
          rest /= n;
          q /= many;
        }
        sum += basis * from[place];
      }
      value[f][c][p] = S(sum);
    });
  }
};

/// The motion of the wall below the points; with Tangent also what motion.tangent has.
template <class Shape, class Motion, bool Tangent>
struct RowWall : WallFields<Shape::D, Motion, Tangent> {
  using Real = typename Shape::Real;
  using Names = WallFields<Shape::D, Motion, Tangent>;
  static constexpr int D = Shape::D, n = Shape::n, size = Names::wall_numbers * Shape::all_wall_points;

  Real* wall;  ///< [number][point of the wall]

  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load(const Team& team, const Motion& motion, const Region<D, Real>& region,
                                        const ElementRow<D>& row, const RowTables<Shape>& table) const {
    if constexpr (Names::moves)
      for_each_index<Names::wall_fields>([&](auto f) {
        constexpr int i = f() % D;
        const Real* const from = f() < D       ? motion.displacement[i]
                                 : f() < 2 * D ? motion.velocity[i]
                                               : motion.tangent[i];
        load_field<f()>(team, from, region, row, table);
      });
  }

 private:
  /// One field of the wall's row with its slopes; zero where there is none.
  template <int f, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_field(const Team& team, const Real* from, const Region<D, Real>& region,
                                              const ElementRow<D>& row, const RowTables<Shape>& table) const {
    constexpr int all = Shape::all_wall_points, functions = power(n, D - 1);
    share(team, (Names::wall_slopes(f) ? D : 1) * all, [&](int item) {
      const int c = item / all, w = item % all, e = w / Shape::wall_points, q = w % Shape::wall_points;
      const Batch<D> b = row.batch(e);
      int first = b.element[0];
      if constexpr (D == 3) first += region.axis[1].first(b.element[1]) * region.stride[1];
      Real sum = 0;
      for (int a = 0; a < functions && from; ++a) {
        Real basis = table.basis(0, c == 1, e * Shape::Q + q % Shape::Q, a % n);
        if constexpr (D == 3) basis *= table.basis(1, c == 2, q / Shape::Q, a / n);
        sum += basis * from[first + a % n + (D == 3 ? a / n * region.stride[1] : 0)];
      }
      wall[(Names::wall_place(f) + c) * all + w] = sum;
    });
  }
};

/// Geometry at the points of element e of a row, as point_at wants it.
template <class N, class Shape, class Motion>
struct RowGeometry {
  using S = typename Shape::S;
  static constexpr int D = Shape::D;
  const Motion& motion;
  const typename Shape::Real* wall;  ///< of all elements
  int e;

  template <bool face>
  KOKKOS_FORCEINLINE_FUNCTION auto at(int q, const Vector<S, D>& reference, double height) const {
    const int w = e * Shape::wall_points + q % Shape::wall_points;
    return point_above_wall<N, Shape::all_wall_points, face>(motion, wall + w, reference, height);
  }
};

}  // namespace softwet
