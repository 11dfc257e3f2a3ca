// The sweeps of a tile: from control values to values at points, and from integrands back to control values. Each sum
// is made by one thread in one order.
#pragma once

#include "operator/device/tile_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

/// Control `place` of a line takes from the elements place - P .. place, as far as there are `elements`; their Q points
/// follow each other. sum[c] = sum over points of basis times from(c, point).
template <int P, int Q, int elements, int sums, class Real, class From>
KOKKOS_FORCEINLINE_FUNCTION void fold_line(const Real* table, int place, Real (&sum)[sums], const From& from) {
  constexpr int n = P + 1;
  SOFTWET_UNROLL
  for (int c = 0; c < sums; ++c) sum[c] = 0;
  const auto add = [&](int e, int a) {
    SOFTWET_UNROLL
    for (int q = 0; q < Q; ++q) {
      const Real basis = table[(e * Q + q) * n + a];
      SOFTWET_UNROLL
      for (int c = 0; c < sums; ++c) sum[c] = sum[c] + basis * from(c, e * Q + q);
    }
  };
  if constexpr (elements == 1) {
    add(0, place);
  } else {
    SOFTWET_UNROLL
    for (int a = P; a >= 0; --a)
      if (place >= a && place < elements + a) add(place - a, a);
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

  /// Where the integers of Room::places stand.
  static KOKKOS_FORCEINLINE_FUNCTION int* places(Real* tables) { return reinterpret_cast<int*>(tables + Room::places); }
  static KOKKOS_FORCEINLINE_FUNCTION const int* places(const Real* tables) {
    return reinterpret_cast<const int*>(tables + Room::places);
  }

  /// Every plane and line of a pass along x. field(f, at): value `at` of a field. All fields are read before one is
  /// written: a compiler cannot know that these are different memory.
  template <class Team, class Field>
  static KOKKOS_FORCEINLINE_FUNCTION void along_x(const Team& team, int pass, const Real* tables, Real* out,
                                                  const Field& field) {
    share(team, Room::x_swept, [&](int i) {
      const int line = quotient(i, Shape::qx), q = modulo(i, Shape::qx), k = quotient(line, Shape::cy);
      int at = places(tables)[quotient(q, Q)] + places(tables)[Room::z_places + pass * Shape::L + k];
      if constexpr (D == 3) at += places(tables)[Room::y_places + modulo(line, Shape::cy)];
      Real value[Plan::fields][n], basis[n];
      for_each_index<Plan::fields>([&](auto f) {
        const Real* from = field(f, at);
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) value[f()][a] = constant(from + a);
      });
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) basis[a] = tables[Room::x + q * n + a];
      for_each_index<Plan::fields>([&](auto f) { out[f() * Room::field + i] = combination(basis, value[f()], 1); });
    });
  }

  /// In 2D: point p of a pass: values of fields with gradients to `values`, others to own.value; on a wall slopes
  /// across it too.
  template <class Own>
  static KOKKOS_FORCEINLINE_FUNCTION void along_z(int p, int pass, const Real* tables, const Real* in, Real* values,
                                                  Own& own) {
    const int z = quotient(p, Shape::base);
    Real basis[n];
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) basis[a] = tables[Room::z + (pass * Shape::qz + z) * n + a];
    const Real* from = in + layer(p) * Shape::base + modulo(p, Shape::base);
    Real sum[Plan::fields];
    for_each_index<Plan::fields>([&](auto f) { sum[f()] = combination(basis, from + f() * Room::field, Shape::base); });
    for_each_index<Plan::fields>([&](auto f) {
      if constexpr (Plan::has_gradient(f())) {
        values[Plan::stored_before(f()) * Shape::points + p] = sum[f()];
      } else {
        own.value[f()] = sum[f()];
      }
    });
    if constexpr (Plan::on_wall) {
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) basis[a] = tables[Room::z_slope + z * n + a];
      for_each_index<Plan::fields>(
          [&](auto f) { own.across[f()] = combination(basis, from + f() * Room::field, Shape::base); });
    }
  }

  /// The layer of a pass with point p.
  static KOKKOS_FORCEINLINE_FUNCTION int layer(int p) {
    return Shape::L == 1 ? 0 : quotient(p, Shape::base * Shape::QL);
  }

  /// Point p of a pass in its element, and how far the points of the element are from it along each axis, itself first.
  static KOKKOS_FORCEINLINE_FUNCTION void neighbours(int p, int (&q)[D], int (&step)[D][Q]) {
    const int stride[3] = {1, D == 3 ? Shape::qx : Shape::base, Shape::base};
    q[0] = modulo(p, Q);
    if constexpr (D == 3) q[1] = modulo(quotient(p, Shape::qx), Q);
    q[D - 1] = quotient(p, Shape::base) - layer(p) * Shape::QL;
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r) step[d][r] = q[d] + r < Q ? r * stride[d] : (r - Q) * stride[d];
  }

  /// The integrand at point p and the fluxes at the points of its element along the first axes, as an integrand against
  /// values and fluxes along the other ones. On a face fluxes are tangential.
  template <int axes, class Own>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_fluxes(const Collocation<D, Q, Real>& slope, int p, const Real* flux,
                                                      const Own& own, Real* out) {
    int q[D], step[D][Q];
    Real row[axes][Q], sum[Plan::channels];
    neighbours(p, q, step);
    SOFTWET_UNROLL
    for (int d = 0; d < axes; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r) row[d][r] = slope.transposed[d][q[d]][r];
    SOFTWET_UNROLL
    for (int c = 0; c < Plan::channels; ++c) {
      sum[c] = own.integrand[c];
      if constexpr (Plan::Test::has_flux) SOFTWET_UNROLL
      for (int d = 0; d < axes; ++d) {
        sum[c] = sum[c] + row[d][0] * own.flux[c][d];
        SOFTWET_UNROLL
        for (int r = 1; r < Q; ++r)
          sum[c] = sum[c] + row[d][r] * flux[(c * axes + d) * Room::point_field + p + step[d][r]];
      }
    }
    SOFTWET_UNROLL
    for (int c = 0; c < Plan::channels; ++c) out[c * Room::point_field + p] = sum[c];
  }

  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_z(const Team& team, int pass, const Real* tables, const Real* in,
                                                 Real* out) {
    share(team, Room::z_folded, [&](int i) {
      const int at = modulo(i, Shape::base);
      Real sum[Plan::channels];
      fold_line<P, Shape::QL, Shape::L>(tables + Room::test + pass * Shape::qz * n, quotient(i, Shape::base), sum,
                                        [&](int c, int q) { return in[c * Shape::points + q * Shape::base + at]; });
      SOFTWET_UNROLL
      for (int c = 0; c < Plan::channels; ++c) out[c * Room::z_folded + i] = sum[c];
    });
  }
  /// Adds to the sums of the tile.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Team& team, int pass, const Real* tables, const Real* in,
                                                 Real* sums) {
    constexpr int lines = Shape::cy * Shape::cz;
    share(team, Shape::cx * lines * Plan::channels, [&](int i) {
      const int x = modulo(i, Shape::cx), line = modulo(quotient(i, Shape::cx), lines),
                c = quotient(i, Shape::cx * lines);
      Real sum[1];
      fold_line<P, Q, Shape::NX>(tables + Room::x, x, sum,
                                 [&](int, int q) { return in[c * Room::x_swept + line * Shape::qx + q]; });
      const int below = Shape::Shared ? 0 : pass * Shape::L * Shape::cy;
      sums[c * Shape::controls + (below + line) * Shape::cx + x] += sum[0];
    });
  }
};

}  // namespace softwet
