// The sweeps of a tile with slopes of its own: values and slopes from control values along one axis after another. Each
// sum is made by one thread in one order.
//
// The last axis comes first: there a layer of elements has the fewest points and the most control values, and nothing
// is summed twice in the next layer. In 3D the thread keeps these sums and sweeps them along y. Sums along the first
// axis are made at the points themselves. On the way back the first axis comes first (slope_folds.hpp).
#pragma once

#include "operator/device/slope_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

template <class Plan>
struct SlopeSweeps {
  using Shape = typename Plan::Shape;
  using Room = SlopeScratch<Plan>;
  using Real = typename Plan::Real;
  static constexpr int D = Shape::D, n = Shape::n, Q = Shape::Q, QL = Shape::QL, cx = Shape::cx;
  using Basis = PointBasis<n, Real>;

  /// Where the integers of Room::places stand.
  static KOKKOS_FORCEINLINE_FUNCTION int* places(Real* t) { return reinterpret_cast<int*>(t + Room::places); }
  static KOKKOS_FORCEINLINE_FUNCTION const int* places(const Real* t) {
    return reinterpret_cast<const int*>(t + Room::places);
  }
  /// Where a field has its numbers.
  static KOKKOS_FORCEINLINE_FUNCTION int swept(int f) {
    return Room::swept + (f + (D - 1) * Plan::stored_before(f)) * Room::apart;
  }

  /// Sweeps across. An item is one field in a stack of elements of a pass at control x; in 3D in one element across.
  /// field(f) gives its control values.
  template <class Team, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void across(const Team& team, int pass, Real* t, const Field& field) {
    constexpr int rows = D == 3 ? n : 1, items = Shape::NY * cx;
    struct Columns {
      Real value[rows][n];
    };
    share_reads<items * Plan::fields, Columns>(
        team,
        [&](int i, Columns& own) {
          const int e = modulo(quotient(i, cx), Shape::NY);
          const int* const place = places(t);
          const Real* const p = field(quotient(i, items)) + place[modulo(i, cx)];
          SOFTWET_UNROLL
          for (int j = 0; j < rows; ++j) SOFTWET_UNROLL
          for (int k = 0; k < n; ++k)
            own.value[j][k] =
                constant(p + (place[Room::z_places + pass + k] + (D == 3 ? place[Room::y_places + e + j] : 0)));
        },
        [&](int i, const Columns& own) {
          const int f = quotient(i, items), e = modulo(quotient(i, cx), Shape::NY);
          Real* const to = t + swept(f) + e * cx + modulo(i, cx);
          if constexpr (D == 3) {
            along_z_and_y(own.value, pass, e, Plan::has_gradient(f), t, to);
          } else {
            along_z(own.value[0], pass, Plan::has_gradient(f), t, to);
          }
        });
  }

  /// Values and slopes of all fields of the wall at the base points, to Room::wall. A tangent that is not there is
  /// zero. field(f): its control values, or null. An item of the last sweep: the points of an element at one place
  /// across.
  template <class Team, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void trace(const Team& team, Real* t, const Field& field) {
    if constexpr (D == 3) trace_across(team, t, field);
    constexpr int items = Shape::NX * Shape::qy;
    share_known<items * Plan::wall_fields>(team, [&](int i) {
      const int f = quotient(i, items), e = quotient(modulo(i, items), Shape::qy), across = modulo(i, Shape::qy);
      Real value[n], slope_y[n] = {};
      if constexpr (D == 3) {
        const Real* const from = t + 2 * f * lines_across + y_of(across) * cx + e;
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) {
          value[a] = from[a];
          slope_y[a] = from[lines_across + a];
        }
      } else {
        read(field(f), value, [&](int a) { return places(t)[e + a]; });
      }
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) {
        const Basis basis(t + Room::x, e * Q + q);
        Real* const to = t + Room::wall + Plan::wall_place(f) * Shape::base +
                         (D == 3 ? q * Shape::NX + e : e * Q + q) * Shape::qy + across;  // as in PointNumbers
        to[0] = Basis::sum(basis.value, value, 1);
        if (!Plan::wall_slopes(f)) continue;
        to[Shape::base] = Basis::sum(basis.slope, value, 1);
        if constexpr (D == 3) to[2 * Shape::base] = Basis::sum(basis.value, slope_y, 1);
      }
    });
    if constexpr (D == 3) team.barrier();  // the first sweep writes where this one reads
  }

 private:
  static constexpr int lines_across = Shape::qy * cx;

  /// Point `across` of those at one place along x, as in PointNumbers.
  static KOKKOS_FORCEINLINE_FUNCTION int y_of(int across) {
    return modulo(across, Shape::NY) * Q + quotient(across, Shape::NY);
  }

  /// An item: the points of an element across, at control x of the wall.
  template <class Team, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void trace_across(const Team& team, Real* t, const Field& field) {
    constexpr int items = Shape::NY * cx;
    struct Controls {
      Real value[n];
    };
    share_reads<items * Plan::wall_fields, Controls>(
        team,
        [&](int i, Controls& own) {
          const int x = modulo(i, cx), e = modulo(quotient(i, cx), Shape::NY);
          read(field(quotient(i, items)), own.value,
               [&](int a) { return places(t)[x] + places(t)[Room::y_places + e + a]; });
        },
        [&](int i, const Controls& own) {
          const int x = modulo(i, cx), e = modulo(quotient(i, cx), Shape::NY), f = quotient(i, items);
          SOFTWET_UNROLL
          for (int q = 0; q < Q; ++q) {
            const Basis basis(t + Room::y, e * Q + q);
            Real* const to = t + 2 * f * lines_across + (e * Q + q) * cx + x;
            to[0] = Basis::sum(basis.value, own.value, 1);
            to[lines_across] = Basis::sum(basis.slope, own.value, 1);
          }
        });
    team.barrier();
  }

  static KOKKOS_FORCEINLINE_FUNCTION void along_z(const Real (&control)[n], int pass, bool slopes, const Real* t,
                                                  Real* to) {
    SOFTWET_UNROLL
    for (int q = 0; q < QL; ++q) {
      const Basis basis(t + Room::z, pass * QL + q);
      to[q * cx] = Basis::sum(basis.value, control, 1);
      if (slopes) to[Room::apart + q * cx] = Basis::sum(basis.slope, control, 1);
    }
  }

  static KOKKOS_FORCEINLINE_FUNCTION void along_z_and_y(const Real (&control)[n][n], int pass, int e, bool slopes,
                                                        const Real* t, Real* to) {
    Real value[QL][n], slope[QL][n];
    SOFTWET_UNROLL
    for (int z = 0; z < QL; ++z) {
      const Basis basis(t + Room::z, pass * QL + z);
      SOFTWET_UNROLL
      for (int j = 0; j < n; ++j) {
        value[z][j] = Basis::sum(basis.value, control[j], 1);
        slope[z][j] = Basis::sum(basis.slope, control[j], 1);
      }
    }
    SOFTWET_UNROLL
    for (int q = 0; q < Q; ++q) {
      const Basis basis(t + Room::y, e * Q + q);
      SOFTWET_UNROLL
      for (int z = 0; z < QL; ++z) {
        Real* const at = to + (z * Shape::qy + q * Shape::NY) * cx;
        at[0] = Basis::sum(basis.value, value[z], 1);
        if (!slopes) continue;
        at[Room::apart] = Basis::sum(basis.slope, value[z], 1);
        at[2 * Room::apart] = Basis::sum(basis.value, slope[z], 1);
      }
    }
  }

  template <class Place>
  static KOKKOS_FORCEINLINE_FUNCTION void read(const Real* from, Real (&value)[n], const Place& place) {
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) value[a] = from ? constant(from + place(a)) : Real(0);
  }
};

}  // namespace softwet
