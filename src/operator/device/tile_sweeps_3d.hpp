// The sweeps of a tile in 3D across the wall and above it, two axes at once: what a thread sweeps along one axis it keeps for the
// other one. A device reads and writes the memory that a team shares less often then, and waits at fewer barriers.
#pragma once

#include "operator/device/tile_sweeps.hpp"

namespace softwet {

/// The points of a line of elements back to its control values: in[Q * elements] to sum[elements + P]. Each sum takes its points in
/// their order.
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
  static constexpr int P = Shape::P, n = Shape::n, Q = Shape::Q, QL = Shape::QL;

  /// An item: the points above each other of an element across, at one place along x, of one field. Fields with gradients go to
  /// `values`, others, and slopes across a wall, to `kept`.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_y_and_z(const Team& team, int pass, const Real* tables, const Real* in,
                                                        Real* values, Real* kept) {
    constexpr int line = Shape::qx * Shape::NY;
    share(team, line * Plan::fields, [&](int i) {
      const int f = quotient(i, line), at = modulo(i, line), e = quotient(at, Shape::qx), x = modulo(at, Shape::qx);
      const Real* from = in + f * Room::field + e * Shape::qx + x;
      Real swept[Q][n];
      SOFTWET_UNROLL
      for (int q = 0; q < Q; ++q) {
        Real basis[n];
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) basis[a] = tables[Room::y + (e * Q + q) * n + a];
        SOFTWET_UNROLL
        for (int k = 0; k < n; ++k)
          swept[q][k] = Sweeps::combination(basis, from + k * Shape::cy * Shape::qx, Shape::qx);
      }
      const int before = Plan::stored_before(f), first = e * Q * Shape::qx + x;
      sweep_above(
          tables + Room::z + pass * QL * n, swept,
          (Plan::has_gradient(f) ? values + before * Shape::points : kept + (f - before) * Shape::points) + first);
      if constexpr (Plan::on_wall)
        sweep_above(tables + Room::z_slope, swept, kept + (Room::across + f) * Shape::points + first);
    });
  }

  /// What a point keeps for itself, from memory.
  template <class Own>
  static KOKKOS_FORCEINLINE_FUNCTION void take(const Real* kept, Own& own) {
    for_each_index<Plan::fields>([&](auto f) {
      if constexpr (!Plan::has_gradient(f())) own.value[f()] = kept[(f() - Plan::stored_before(f())) * Shape::points];
      if constexpr (Plan::on_wall) own.across[f()] = kept[(Room::across + f()) * Shape::points];
    });
  }

  /// An item: a line of points across at one place along x, for one plane of control values and one channel.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_z_and_y(const Team& team, int pass, const Real* tables, const Real* in,
                                                       Real* out) {
    share(team, Shape::qx * Shape::cz * Plan::channels, [&](int i) {
      const int k = modulo(i, Shape::cz), c = quotient(i, Shape::qx * Shape::cz);
      const int x = quotient(i, Shape::cz) - c * Shape::qx;
      Real folded[Shape::qy], sum[Shape::cy];
      SOFTWET_UNROLL
      for (int y = 0; y < Shape::qy; ++y) folded[y] = 0;
      SOFTWET_UNROLL
      for (int q = 0; q < QL; ++q) {
        const Real basis = tables[Room::test + (pass * QL + q) * n + k];
        SOFTWET_UNROLL
        for (int y = 0; y < Shape::qy; ++y)
          folded[y] = folded[y] + basis * in[c * Shape::points + q * Shape::base + y * Shape::qx + x];
      }
      fold_whole_line<P, Q, Shape::NY>(tables + Room::y, folded, sum);
      SOFTWET_UNROLL
      for (int j = 0; j < Shape::cy; ++j) out[c * Room::x_swept + (k * Shape::cy + j) * Shape::qx + x] = sum[j];
    });
  }

  /// Adds to the sums of the tile. An item: a line of control values of one channel. The last threads take them, since the first ones
  /// go on to sweep the next pass along x.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Team& team, int pass, const Real* tables, const Real* in,
                                                 Real* sums) {
    constexpr int lines = Shape::cy * Shape::cz, count = lines * Plan::channels;
    share_from(team, Team::size > count ? Team::size - count : 0, count, [&](int i) {
      const int line = modulo(i, lines), c = quotient(i, lines);
      Real folded[Shape::qx], sum[Shape::cx];
      SOFTWET_UNROLL
      for (int q = 0; q < Shape::qx; ++q) folded[q] = in[c * Room::x_swept + line * Shape::qx + q];
      fold_whole_line<P, Q, Shape::NX>(tables + Room::x, folded, sum);
      const int below = Shape::Shared ? 0 : pass * Shape::cy;
      Real* const to = sums + c * Shape::controls + (below + line) * Shape::cx;
      SOFTWET_UNROLL
      for (int x = 0; x < Shape::cx; ++x) to[x] += sum[x];
    });
  }

 private:
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
};

}  // namespace softwet
