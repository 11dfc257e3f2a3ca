// The sweeps of a tile: from control values to values at points, and from integrands back to control values. Each sum is made
// by one thread in one order.
#pragma once

#include "operator/device/tile_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

/// Control `place` of a line takes from the elements place - P .. place, as far as there are `elements`; their Q points follow
/// each other. sum[c] = sum over points of basis times from(c, point).
template <int P, int Q, int elements, int sums, class Real, class From>
KOKKOS_FORCEINLINE_FUNCTION void fold_line(const Real* table, int place, Real (&sum)[sums], const From& from) {
  constexpr int n = P + 1;
  SOFTWET_UNROLL
  for (int c = 0; c < sums; ++c) sum[c] = 0;
  for (int a = elements == 1 ? place : P; a >= (elements == 1 ? place : 0); --a) {
    const int e = place - a;
    if (e < 0 || e >= elements) continue;
    for (int q = 0; q < Q; ++q) {
      const Real basis = table[(e * Q + q) * n + a];
      SOFTWET_UNROLL
      for (int c = 0; c < sums; ++c) sum[c] = sum[c] + basis * from(c, e * Q + q);
    }
  }
}

template <class Plan>
struct TileSweeps {
  using Shape = typename Plan::Shape;
  using Room = TileScratch<Plan>;
  using Real = typename Plan::Real;
  static constexpr int D = Shape::D, P = Shape::P, n = Shape::n, Q = Shape::Q;

  /// sum_a basis[a] value[a stride]
  static KOKKOS_FORCEINLINE_FUNCTION Real combination(const Real (&basis)[n], const Real* value, int stride) {
    Real sum = basis[0] * value[0];
    SOFTWET_UNROLL
    for (int a = 1; a < n; ++a) sum = sum + basis[a] * value[a * stride];
    return sum;
  }

  /// Every plane and line of a pass along x. control(i, j, k): place of a control value; field(f): its array.
  template <class Team, class Control, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void along_x(const Team& team, const Real* tables, Real* out,
                                                  const Control& control, const Field& field) {
    share(team, Room::x_swept, [&](int i) {
      const int q = i % Shape::qx, j = i / Shape::qx % Shape::cy, k = i / Shape::qx / Shape::cy;
      Real basis[n];
      int at[n];
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) {
        basis[a] = tables[Room::x + q * n + a];
        at[a] = control(q / Q + a, j, k);
      }
      for_each_index<Plan::fields>([&](auto f) {
        const Real* p = field(f);
        Real sum = basis[0] * p[at[0]];
        SOFTWET_UNROLL
        for (int a = 1; a < n; ++a) sum = sum + basis[a] * p[at[a]];
        out[f() * Room::x_swept + i] = sum;
      });
    });
  }

  /// An item: the Q points of an element across, of one field, line and plane. The items of a thread lie on one element.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_y(const Team& team, const Real* tables, const Real* in, Real* out) {
    constexpr int line = Shape::qx * Shape::NY, count = line * Shape::cz * Plan::fields;
    constexpr bool one_element = Team::size % line == 0;
    Real basis[Q][n];
    const auto load = [&](int i) {
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) basis[q][a] = tables[Room::y + (i / Shape::qx % Shape::NY * Q + q) * n + a];
    };
    load(team.rank());
    share(team, count, [&](int i) {
      if constexpr (!one_element) load(i);
      const int x = i % Shape::qx, e = i / Shape::qx % Shape::NY, plane = i / line;  // planes of all fields
      const Real* from = in + (plane * Shape::cy + e) * Shape::qx + x;
      Real* to = out + plane * Shape::base + e * Q * Shape::qx + x;
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) to[q * Shape::qx] = combination(basis[q], from, Shape::qx);
    });
  }

  /// Point p of a pass: values of fields with gradients to `values`, others to own.value; on a wall slopes across it too.
  template <class Own>
  static KOKKOS_FORCEINLINE_FUNCTION void along_z(int p, int pass, const Real* tables, const Real* in, Real* values,
                                                  Own& own) {
    const int z = p / Shape::base;
    Real basis[n];
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) basis[a] = tables[Room::z + (pass * Shape::qz + z) * n + a];
    const Real* from = in + z / Shape::QL * Shape::base + p % Shape::base;
    for_each_index<Plan::fields>([&](auto f) {
      const Real sum = combination(basis, from + f() * Room::y_swept, Shape::base);
      if constexpr (Plan::has_gradient(f())) {
        values[Plan::stored_before(f()) * Shape::points + p] = sum;
      } else {
        own.value[f()] = sum;
      }
    });
    if constexpr (Plan::on_wall) {
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) basis[a] = tables[Room::z_slope + z * n + a];
      for_each_index<Plan::fields>(
          [&](auto f) { own.across[f()] = combination(basis, from + f() * Room::y_swept, Shape::base); });
    }
  }

  /// Point p of a pass in its element, and how far the points of the element are from it along each axis, itself first.
  static KOKKOS_FORCEINLINE_FUNCTION void neighbours(int p, int (&q)[D], int (&step)[D][Q]) {
    const int stride[3] = {1, D == 3 ? Shape::qx : Shape::base, Shape::base};
    q[0] = p % Shape::qx % Q;
    if constexpr (D == 3) q[1] = p / Shape::qx % Shape::qy % Q;
    q[D - 1] = p / Shape::base % Q;
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r) step[d][r] = ((q[d] + r) % Q - q[d]) * stride[d];
  }

  /// The integrand at point p and the fluxes at the points of its element, as an integrand against values alone. On a face fluxes
  /// are tangential.
  static KOKKOS_FORCEINLINE_FUNCTION void fold_fluxes(const Collocation<D, Q, Real>& slope, int p, const Real* flux,
                                                      const Real (&integrand)[Plan::channels], Real* out) {
    int q[D], step[D][Q];
    Real row[D][Q];
    neighbours(p, q, step);
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r) row[d][r] = slope.transposed[d][q[d]][r];
    SOFTWET_UNROLL
    for (int c = 0; c < Plan::channels; ++c) {
      Real sum = integrand[c];
      if constexpr (Plan::Test::has_flux) SOFTWET_UNROLL
      for (int d = 0; d < Plan::collocated; ++d) SOFTWET_UNROLL
      for (int r = 0; r < Q; ++r) sum = sum + row[d][r] * flux[(c * D + d) * Shape::points + p + step[d][r]];
      out[c * Shape::points + p] = sum;
    }
  }

  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_z(const Team& team, int pass, const Real* tables, const Real* in,
                                                 Real* out) {
    share(team, Room::y_swept, [&](int i) {
      const int at = i % Shape::base;
      Real sum[Plan::channels];
      fold_line<P, Shape::QL, Shape::L>(tables + Room::test + pass * Shape::qz * n, i / Shape::base, sum,
                                        [&](int c, int q) { return in[c * Shape::points + q * Shape::base + at]; });
      SOFTWET_UNROLL
      for (int c = 0; c < Plan::channels; ++c) out[c * Room::y_swept + i] = sum[c];
    });
  }
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_y(const Team& team, const Real* tables, const Real* in, Real* out) {
    share(team, Room::x_swept, [&](int i) {
      const int q = i % Shape::qx, j = i / Shape::qx % Shape::cy, k = i / Shape::qx / Shape::cy;
      Real sum[Plan::channels];
      fold_line<P, Q, Shape::NY>(tables + Room::y, j, sum, [&](int c, int y) {
        return in[c * Room::y_swept + k * Shape::base + y * Shape::qx + q];
      });
      SOFTWET_UNROLL
      for (int c = 0; c < Plan::channels; ++c) out[c * Room::x_swept + i] = sum[c];
    });
  }
  /// Adds to the sums of the tile.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Team& team, int pass, const Real* tables, const Real* in,
                                                 Real* sums) {
    constexpr int lines = Shape::cy * Shape::cz;
    share(team, Shape::cx * lines * Plan::channels, [&](int i) {
      const int x = i % Shape::cx, line = i / Shape::cx % lines, c = i / Shape::cx / lines;
      Real sum[1];
      fold_line<P, Q, Shape::NX>(tables + Room::x, x, sum,
                                 [&](int, int q) { return in[c * Room::x_swept + line * Shape::qx + q]; });
      const int below = Shape::Shared ? 0 : pass * Shape::L * Shape::cy;
      sums[c * Shape::controls + (below + line) * Shape::cx + x] += sum[0];
    });
  }
};

}  // namespace softwet
