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

  /// Values and slopes of all fields of the wall at the base points, to Room::wall. A tangent that is not there is
  /// zero. field(f): the control values of a field, or null. An item is a point of one field.
  template <class Team, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void trace(const Team& team, const Collocation<D, Q, Real>& slope, Real* t,
                                                const Field& field) {
    constexpr int lines = Shape::cy * Shape::qx;
    const int* const places = reinterpret_cast<const int*>(t + Room::places);
    share(team, Plan::wall_fields * lines, [&](int item) {
      const int f = quotient(item, lines), i = modulo(item, lines), q = modulo(i, Shape::qx);
      const Real* const p = field(f);
      int at = places[quotient(q, Q)];
      if constexpr (D == 3) at += places[Room::y_places + quotient(i, Shape::qx)];
      Real sum = 0;
      if (p) SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) sum = sum + t[Room::x + q * n + a] * constant(p + at + a);
      t[D == 3 ? Room::first + item : Room::wall + Plan::wall_place(f) * Shape::base + i] = sum;
    });
    team.barrier();
    if constexpr (D == 3) {
      share(team, Plan::wall_fields * Shape::base, [&](int item) {
        const int f = quotient(item, Shape::base), i = modulo(item, Shape::base);
        const int q = modulo(i, Shape::qx), y = quotient(i, Shape::qx);
        const Real* from = t + Room::first + (f * Shape::cy + quotient(y, Q)) * Shape::qx + q;
        Real sum = 0;
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) sum = sum + t[Room::y + y * n + a] * from[a * Shape::qx];
        t[Room::wall + Plan::wall_place(f) * Shape::base + i] = sum;
      });
      team.barrier();
    }
    static_assert(Plan::wall_slopes(0) && !Plan::wall_slopes(D) && Plan::wall_slopes(2 * D));
    constexpr int sloped = Plan::wall_fields / D - 1;  // sets of D fields: the second has no slopes
    share(team, sloped * D * Shape::base, [&](int item) {
      const int f = quotient(item, Shape::base);
      add_slopes(slope, t, modulo(item, Shape::base),
                 t + Room::wall + Plan::wall_place(f < D ? f : f + D) * Shape::base);
    });
    team.barrier();
  }

  /// The slopes along the wall at point i of the values in v[0 .. base - 1], behind them.
  static KOKKOS_FORCEINLINE_FUNCTION void add_slopes(const Collocation<D, Q, Real>& slope, const Real* tables, int i,
                                                     Real* v) {
    const int x = modulo(i, Shape::qx), y = quotient(i, Shape::qx), stride[2] = {1, Shape::qx};
    const int q[2] = {modulo(x, Q), modulo(y, Q)};
    const int share[2] = {Room::x_share + quotient(x, Q), Room::y_share + quotient(y, Q)};
    SOFTWET_UNROLL
    for (int d = 0; d < D - 1; ++d) {
      Real sum = 0;
      SOFTWET_UNROLL
      for (int r = 0; r < Q; ++r) sum = sum + slope.forward[d][q[d]][r] * v[i + (q[d] + r < Q ? r : r - Q) * stride[d]];
      v[(1 + d) * Shape::base + i] = sum * tables[share[d]];
    }
  }
};

}  // namespace softwet
