// The sweeps of a tile with slopes of its own: values and slopes from control values along one axis after another, and integrands
// against values and slopes back to control values. Each sum is made by one thread in one order.
//
// The last axis comes first: there a layer of elements has the fewest points and the most control values, and nothing is summed
// twice in the next layer. Sums along the first axis are made at the points themselves. On the way back the first axis comes
// first.
#pragma once

#include "operator/device/slope_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

template <class Plan>
struct SlopeSweeps {
  using Shape = typename Plan::Shape;
  using Room = SlopeScratch<Plan>;
  using Real = typename Plan::Real;
  static constexpr int D = Shape::D, P = Shape::P, n = Shape::n, Q = Shape::Q, QL = Shape::QL, cx = Shape::cx;
  static constexpr int channels = Plan::channels;
  using Test = typename Plan::Test;
  using Basis = PointBasis<n, Real>;

  /// An item: a column of control values of some of the fields. control(i, j, k): place of one; field(f): its array. All that an
  /// item reads is read before it writes, here and below: a device waits for its reads together then.
  template <class Team, class Control, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void along_z(const Team& team, int pass, Real* t, const Control& control,
                                                  const Field& field) {
    constexpr int columns = Room::columns, most = Team::size / columns;
    constexpr int groups = most < 1 ? 1 : most < Plan::fields ? most : Plan::fields;
    constexpr int each = (Plan::fields + groups - 1) / groups;
    share(team, columns * groups, [&](int i) {
      const int column = i % columns, begin = i / columns;
      int at[n];
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) at[a] = control(column % cx, column / cx, a);
      Real value[each][n];
      SOFTWET_UNROLL
      for (int l = 0; l < each; ++l) {
        if (begin + l * groups >= Plan::fields) continue;
        const Real* p = field(begin + l * groups);
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) value[l][a] = p[at[a]];
      }
      Basis basis[QL];
      SOFTWET_UNROLL
      for (int q = 0; q < QL; ++q) basis[q] = Basis(t + Room::z, t + Room::z_slope, pass * QL + q);
      SOFTWET_UNROLL
      for (int l = 0; l < each; ++l) {
        const int f = begin + l * groups;
        if (f >= Plan::fields) continue;
        Real* to = t + Room::swept_z + (f + Plan::stored_before(f)) * Room::layer + column;
        SOFTWET_UNROLL
        for (int q = 0; q < QL; ++q) to[q * columns] = Basis::sum(basis[q].value, value[l], 1);
        if (!Plan::has_gradient(f)) continue;
        SOFTWET_UNROLL
        for (int q = 0; q < QL; ++q) to[Room::layer + q * columns] = Basis::sum(basis[q].slope, value[l], 1);
      }
    });
  }

  /// An item: the Q points of an element along y, of one field, for one x and z. The items of a thread lie on one element.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_y(const Team& team, Real* t) {
    constexpr int NY = Shape::NY;
    constexpr bool one_element = Team::size % NY == 0;
    Basis basis[Q];
    const auto load = [&](int i) {
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) basis[q] = Basis(t + Room::y, t + Room::y_slope, i % NY * Q + q);
    };
    load(team.rank());
    share(team, NY * cx * QL * Plan::fields, [&](int i) {
      if constexpr (!one_element) load(i);
      const int e = i % NY, x = i / NY % cx, z = i / (NY * cx) % QL, f = i / (NY * cx * QL),
                before = Plan::stored_before(f);
      const Real* from = t + Room::swept_z + (f + before) * Room::layer + (z * Shape::cy + e) * cx + x;
      Real* to = t + Room::swept + (f + 2 * before) * Room::line_points + (z * Shape::qy + e * Q) * cx + x;
      const bool slopes = Plan::has_gradient(f);
      Real value[n], slope_z[n];
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) {
        value[a] = from[a * cx];
        if (slopes) slope_z[a] = from[Room::layer + a * cx];
      }
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) to[q * cx] = Basis::sum(basis[q].value, value, 1);
      if (!slopes) return;
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) {
        to[Room::line_points + q * cx] = Basis::sum(basis[q].slope, value, 1);
        to[2 * Room::line_points + q * cx] = Basis::sum(basis[q].value, slope_z, 1);
      }
    });
  }

  /// Control x of a line takes from the points of the elements x - P .. x, as far as there are `elements`: body(basis, point).
  template <int elements, class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void for_points_of(const Real* values, const Real* slopes, int x,
                                                        const Body& body) {
    for (int a = P; a >= 0; --a) {
      const int e = x - a;
      if (e < 0 || e >= elements) continue;
      for (int q = 0; q < Q; ++q) body(values[(e * Q + q) * n + a], slopes[(e * Q + q) * n + a], e * Q + q);
    }
  }

  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Team& team, Real* t) {
    constexpr int folded = Room::folded;
    share(team, Room::line_points, [&](int i) {
      Real sum[channels][folded] = {};
      const Real* from = t + Room::integrands + i / cx * Shape::qx;
      for_points_of<Shape::NX>(t + Room::x, t + Room::x_slope, i % cx, [&](Real value, Real slope, int q) {
        for_each_index<channels>([&](auto c) {
          const Real* of = from + c() * Room::written * Shape::points + q;
          sum[c()][0] = sum[c()][0] + value * of[0];
          if constexpr (channel_has_flux<Test>(c())) {
            sum[c()][0] = sum[c()][0] + slope * of[Shape::points];
            SOFTWET_UNROLL
            for (int d = 1; d < D; ++d) sum[c()][d] = sum[c()][d] + value * of[(1 + d) * Shape::points];
          }
        });
      });
      Real* to = t + Room::folded_x + i;
      for_each_index<channels>([&](auto c) {
        SOFTWET_UNROLL
        for (int d = 0; d < (channel_has_flux<Test>(c()) ? D : 1); ++d)
          to[(c() * folded + d) * Room::line_points] = sum[c()][d];
      });
    });
  }

  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_y(const Team& team, Real* t) {
    constexpr int again = Room::folded_again;
    share(team, Room::layer, [&](int i) {
      Real sum[channels][again] = {};
      const Real* from = t + Room::folded_x + i / Room::columns * Shape::qy * cx + i % cx;
      for_points_of<Shape::NY>(t + Room::y, t + Room::y_slope, i / cx % Shape::cy, [&](Real value, Real slope, int q) {
        for_each_index<channels>([&](auto c) {
          const Real* of = from + c() * Room::folded * Room::line_points + q * cx;
          sum[c()][0] = sum[c()][0] + value * of[0];
          if constexpr (channel_has_flux<Test>(c())) {
            sum[c()][0] = sum[c()][0] + slope * of[Room::line_points];
            sum[c()][1] = sum[c()][1] + value * of[2 * Room::line_points];
          }
        });
      });
      Real* to = t + Room::folded_y + i;
      for_each_index<channels>([&](auto c) {
        to[c() * again * Room::layer] = sum[c()][0];
        if constexpr (channel_has_flux<Test>(c())) to[(c() * again + 1) * Room::layer] = sum[c()][1];
      });
    });
  }

  /// Where the sums of the first channel for plane `plane` of control values are kept: of P + 1 planes that an element has, the
  /// last take the places of those that are complete. Channels are `kept_apart`.
  static KOKKOS_FORCEINLINE_FUNCTION int kept(int plane) { return Room::sums + plane % n * Room::columns; }
  static constexpr int kept_apart = n * Room::columns;

  /// Adds to the sums. A plane that no later pass reaches goes to `out`, [channel][plane][column] of the tile.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_z(const Team& team, int pass, Real* t, Real* out) {
    constexpr int columns = Room::columns;
    share(team, n * columns, [&](int i) {
      const int column = i % columns, a = i / columns, plane = Shape::Shared ? a : pass + a;
      Real* const sums = t + kept(plane) + column;
      Real value[QL], slope[QL], sum[channels];
      SOFTWET_UNROLL
      for (int q = 0; q < QL; ++q) {
        value[q] = t[Room::test + (pass * QL + q) * n + a];
        slope[q] = t[Room::test_slope + (pass * QL + q) * n + a];
      }
      const bool begun = pass > 0 && (Shape::Shared || a < P);
      SOFTWET_UNROLL
      for (int c = 0; c < channels; ++c) sum[c] = begun ? sums[c * kept_apart] : Real(0);
      for_each_index<channels>([&](auto c) {
        const Real* of = t + Room::folded_y + c() * Room::folded_again * Room::layer + column;
        SOFTWET_UNROLL
        for (int q = 0; q < QL; ++q) {
          sum[c()] = sum[c()] + value[q] * of[q * columns];
          if constexpr (channel_has_flux<Test>(c())) sum[c()] = sum[c()] + slope[q] * of[Room::layer + q * columns];
        }
      });
      if (!Shape::Shared && a == 0) {
        SOFTWET_UNROLL
        for (int c = 0; c < channels; ++c) out[c * Shape::controls + plane * columns + column] = sum[c];
      } else {
        SOFTWET_UNROLL
        for (int c = 0; c < channels; ++c) sums[c * kept_apart] = sum[c];
      }
    });
  }
  /// The planes that are left after so many passes; those of layers outside of the region are zero.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void store(const Team& team, int passes, const Real* t, Real* out) {
    constexpr int columns = Room::columns;
    const int done = Shape::Shared ? 0 : passes;
    share(team, (Shape::planes - done) * columns, [&](int i) {
      const int plane = done + i / columns, column = i % columns;
      const bool reached = Shape::Shared || plane < passes + P;
      SOFTWET_UNROLL
      for (int c = 0; c < channels; ++c)
        out[c * Shape::controls + plane * columns + column] =
            reached ? t[kept(plane) + c * kept_apart + column] : Real(0);
    });
  }

  /// Values and slopes of all fields of the wall at the base points, to Room::wall. A tangent that is not there is zero.
  /// column(i, j): place of a control point in the wall's row; field(f): its control values, or null.
  template <class Team, class Column, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void trace(const Team& team, Real* t, const Column& column, const Field& field) {
    constexpr int lines = Shape::qy * cx;
    if constexpr (D == 3) {
      share(team, Plan::wall_fields * lines, [&](int i) {
        const int x = i % cx, y = i / cx % Shape::qy, f = i / lines;
        const Basis basis(t + Room::y, t + Room::y_slope, y);
        Real value[n];
        read(value, field(f), [&](int a) { return column(x, y / Q + a); });
        t[2 * f * lines + i % lines] = Basis::sum(basis.value, value, 1);
        t[(2 * f + 1) * lines + i % lines] = Basis::sum(basis.slope, value, 1);
      });
      team.barrier();
    }
    share(team, Plan::wall_fields * Shape::base, [&](int i) {
      const int p = i % Shape::base, x = p % Shape::qx, f = i / Shape::base;
      const Basis basis(t + Room::x, t + Room::x_slope, x);
      Real value[n];
      if constexpr (D == 3) {
        read(value, t + 2 * f * lines + p / Shape::qx * cx + x / Q, [](int a) { return a; });
      } else {
        read(value, field(f), [&](int a) { return column(x / Q + a, 0); });
      }
      Real* to = t + Room::wall + Plan::wall_place(f) * Shape::base + p;
      to[0] = Basis::sum(basis.value, value, 1);
      if (!Plan::wall_slopes(f)) return;
      to[Shape::base] = Basis::sum(basis.slope, value, 1);
      if constexpr (D == 3)
        to[2 * Shape::base] = Basis::sum(basis.value, t + (2 * f + 1) * lines + p / Shape::qx * cx + x / Q, 1);
    });
    team.barrier();
  }

 private:
  template <class Place>
  static KOKKOS_FORCEINLINE_FUNCTION void read(Real (&value)[n], const Real* from, const Place& place) {
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) value[a] = from ? from[place(a)] : Real(0);
  }
};

}  // namespace softwet
