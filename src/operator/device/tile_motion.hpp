// The motion of the wall at the points of a tile.
#pragma once

#include "operator/device/tile_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

template <class Plan>
struct TileMotion {
  using Shape = typename Plan::Shape;
  using Room = TileScratch<Plan>;
  using Real = typename Plan::Real;
  static constexpr int D = Shape::D, n = Shape::n, Q = Shape::Q;

  /// Values and slopes of all fields of the wall at the base points, to Room::wall. A tangent that is not there is zero.
  /// column(i, j): place of a control point in the wall's row; field(f): its control values, or null.
  template <class Team, class Column, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void trace(const Team& team, const Collocation<D, Q, Real>& slope, Real* t,
                                                const Column& column, const Field& field) {
    Real* const swept = D == 3 ? t + Room::first : t + Room::wall;
    for (int f = 0; f < Plan::wall_fields; ++f) {
      const Real* p = field(f);
      Real* const out = D == 3 ? swept + f * Shape::cy * Shape::qx : swept + Plan::wall_place(f) * Shape::base;
      share(team, Shape::cy * Shape::qx, [&](int i) {
        const int q = i % Shape::qx, j = i / Shape::qx;
        Real sum = 0;
        if (p)
          for (int a = 0; a < n; ++a) sum = sum + t[Room::x + q * n + a] * p[column(q / Q + a, j)];
        out[i] = sum;
      });
    }
    team.barrier();
    if constexpr (D == 3) {
      for (int f = 0; f < Plan::wall_fields; ++f)
        share(team, Shape::base, [&](int i) {
          const int q = i % Shape::qx, y = i / Shape::qx;
          const Real* from = swept + (f * Shape::cy + y / Q) * Shape::qx + q;
          Real sum = 0;
          for (int a = 0; a < n; ++a) sum = sum + t[Room::y + y * n + a] * from[a * Shape::qx];
          t[Room::wall + Plan::wall_place(f) * Shape::base + i] = sum;
        });
      team.barrier();
    }
    for (int f = 0; f < Plan::wall_fields; ++f)
      if (Plan::wall_slopes(f)) add_slopes(team, slope, t, t + Room::wall + Plan::wall_place(f) * Shape::base);
    team.barrier();
  }

  /// The slopes along the wall of the values in v[0 .. base - 1], behind them.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void add_slopes(const Team& team, const Collocation<D, Q, Real>& slope,
                                                     const Real* tables, Real* v) {
    share(team, Shape::base, [&](int i) {
      const int q[2] = {i % Shape::qx % Q, i / Shape::qx % Q}, stride[2] = {1, Shape::qx};
      const int share[2] = {Room::x_share + i % Shape::qx / Q, Room::y_share + i / Shape::qx / Q};
      for (int d = 0; d < D - 1; ++d) {
        Real sum = 0;
        for (int r = 0; r < Q; ++r) sum = sum + slope.forward[d][q[d]][r] * v[i + ((q[d] + r) % Q - q[d]) * stride[d]];
        v[(1 + d) * Shape::base + i] = sum * tables[share[d]];
      }
    });
  }
};

}  // namespace softwet
