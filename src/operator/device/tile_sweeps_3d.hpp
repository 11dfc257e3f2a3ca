// The sweeps of a tile in 3D across the wall and above it, two axes at once: what a thread sweeps along one axis it
// keeps for the other one. A device reads and writes the memory that a team shares less often then, and waits at fewer
// barriers.
#pragma once

#include "operator/device/tile_sweeps.hpp"

namespace softwet {

/// The points of a line of elements back to its control values: in[Q * elements] to sum[elements + P]. Each sum takes
/// its points in their order.
template <int P, int Q, int elements, class Real>
KOKKOS_FORCEINLINE_FUNCTION void fold_whole_line(const Real* table, const Real (&in)[Q * elements],
                                                 Real (&sum)[elements + P]) {
  SOFTWET_UNROLL
  for (int i = 0; i < elements + P; ++i) sum[i] = 0;
  SOFTWET_UNROLL
  for (int q = 0; q < Q * elements; ++q) SOFTWET_UNROLL
  for (int a = 0; a <= P; ++a) sum[q / Q + a] = sum[q / Q + a] + table[q * (P + 1) + a] * in[q];
}

template <class Plan>
struct TileSweeps3D {
  using Shape = typename Plan::Shape;
  using Room = TileScratch<Plan>;
  using Real = typename Plan::Real;
  using Sweeps = TileSweeps<Plan>;
  static constexpr int D = 3, P = Shape::P, n = Shape::n, Q = Shape::Q, QL = Shape::QL;

  /// An item: the points above each other of an element across, at one place along x, of one field. Fields with
  /// gradients go to Room::values, others, and slopes across a wall, to Room::kept.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_y_and_z(const Team& team, int pass, Real* t) {
    constexpr int lines = Shape::qx * Plan::fields;
    share(team, lines * Shape::NY, [&](int i) {
      const int e = quotient(i, lines), at = modulo(i, lines), f = quotient(at, Shape::qx), x = modulo(at, Shape::qx);
      const Real* from = t + Room::swept + f * Room::field + e * Shape::qx + x;
      Real swept[Q][n];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) {
        Real basis[n];
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) basis[a] = t[Room::y + (e * Q + q) * n + a];
        SOFTWET_UNROLL
        for (int k = 0; k < n; ++k)
          swept[q][k] = Sweeps::combination(basis, from + k * Shape::cy * Shape::qx, Shape::qx);
      }
      const int before = Plan::stored_before(f), first = e * Q * Shape::qx + x;
      const int place = Plan::has_gradient(f) ? before : Plan::stored + f - before;
      sweep_above(t + Room::z + pass * QL * n, swept, t + place * Room::point_field + first);
      if constexpr (Plan::on_wall)
        sweep_above(t + Room::z_slope, swept, t + Room::kept + (Room::across + f) * Room::point_field + first);
    });
  }

  /// An item: the points above each other and across at one place along x, of one channel. Integrands take what fluxes
  /// along y and z add to them, and are folded along both axes.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_z_and_y(const Team& team, int pass, const Collocation<D, Q, Real>& slope,
                                                       Real* t) {
    share_last(team, Shape::qx * Plan::channels, [&](int i) {
      const int c = quotient(i, Shape::qx), x = modulo(i, Shape::qx);
      const Real* const in = t + c * Room::point_field + x;
      Real integrand[QL][Shape::qy];
      SOFTWET_UNROLL
      for (int z = 0; z < QL; ++z) SOFTWET_UNROLL
      for (int y = 0; y < Shape::qy; ++y) integrand[z][y] = in[z * Shape::base + y * Shape::qx];
      if constexpr (Plan::Test::has_flux) add_fluxes(slope, t + Room::flux + c * Room::point_field + x, integrand);
      SOFTWET_UNROLL
      for (int k = 0; k < Shape::cz; ++k) {
        Real line[Shape::qy], sum[Shape::cy];
        SOFTWET_UNROLL
        for (int y = 0; y < Shape::qy; ++y) line[y] = 0;
        SOFTWET_UNROLL
        for (int z = 0; z < QL; ++z) {
          const Real basis = t[Room::test + (pass * QL + z) * n + k];
          SOFTWET_UNROLL
          for (int y = 0; y < Shape::qy; ++y) line[y] = line[y] + basis * integrand[z][y];
        }
        fold_whole_line<P, Q, Shape::NY>(t + Room::y, line, sum);
        SOFTWET_UNROLL
        for (int j = 0; j < Shape::cy; ++j)
          t[Room::folded_zy + c * Room::field + (k * Shape::cy + j) * Shape::qx + x] = sum[j];
      }
    });
  }

  /// Adds to the sums of the tile. An item: a line of control values of one channel.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Team& team, int pass, Real* t) {
    constexpr int lines = Shape::cy * Shape::cz;
    share_last(team, lines * Plan::channels, [&](int i) {
      const int line = modulo(i, lines), c = quotient(i, lines);
      Real folded[Shape::qx], sum[Shape::cx];
      SOFTWET_UNROLL
      for (int q = 0; q < Shape::qx; ++q) folded[q] = t[Room::folded_zy + c * Room::field + line * Shape::qx + q];
      fold_whole_line<P, Q, Shape::NX>(t + Room::x, folded, sum);
      const int below = Shape::Shared ? 0 : pass * Shape::cy;
      Real* const to = t + Room::sums + c * Shape::controls + (below + line) * Shape::cx;
      SOFTWET_UNROLL
      for (int x = 0; x < Shape::cx; ++x) to[x] += sum[x];
    });
  }

 private:
  /// Items for the last warps, since the first ones sweep meanwhile.
  template <class Team, class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void share_last(const Team& team, int count, const Body& body) {
    share_from(team, Team::size > count ? (Team::size - count) / 32 * 32 : 0, count, body);
  }

  static KOKKOS_FORCEINLINE_FUNCTION void sweep_above(const Real* table, const Real (&swept)[Q][n], Real* to) {
    SOFTWET_UNROLL
    for (int z = 0; z < QL; ++z) {
      Real basis[n];
      SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) basis[a] = table[z * n + a];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) to[z * Shape::base + q * Shape::qx] = Sweeps::combination(basis, swept[q], 1);
    }
  }

  /// Adds to integrands the share of the fluxes along y and z in the values; a point takes its own one first. `flux`:
  /// the fluxes along y, followed by the fluxes of all channels along z.
  static KOKKOS_FORCEINLINE_FUNCTION void add_fluxes(const Collocation<D, Q, Real>& slope, const Real* flux,
                                                     Real (&integrand)[QL][Shape::qy]) {
    SOFTWET_UNROLL
    for (int z = 0; z < QL; ++z) SOFTWET_UNROLL
    for (int e = 0; e < Shape::NY; ++e) {
      Real line[Q];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) line[q] = flux[z * Shape::base + (e * Q + q) * Shape::qx];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) SOFTWET_UNROLL
      for (int r = 0; r < Q; ++r)
        integrand[z][e * Q + q] = integrand[z][e * Q + q] + slope.transposed[1][q][r] * line[(q + r) % Q];
    }
    if constexpr (!Plan::on_wall) SOFTWET_UNROLL
    for (int y = 0; y < Shape::qy; ++y) {
      Real line[Q];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) line[q] = flux[Room::of_flux + q * Shape::base + y * Shape::qx];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) SOFTWET_UNROLL
      for (int r = 0; r < Q; ++r) integrand[q][y] = integrand[q][y] + slope.transposed[2][q][r] * line[(q + r) % Q];
    }
  }
};

}  // namespace softwet
