// The way back in a tile with slopes of its own: integrands at points, against values and slopes, to control values,
// along one axis after another, the first one first. Each sum is made by one thread, which takes the points in their
// order.
#pragma once

#include "operator/device/slope_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

template <class Plan>
struct SlopeFolds {
  using Shape = typename Plan::Shape;
  using Room = SlopeScratch<Plan>;
  using Real = typename Plan::Real;
  using Channels = typename Room::Channels;
  static constexpr int D = Shape::D, P = Shape::P, n = Shape::n, Q = Shape::Q, QL = Shape::QL, cx = Shape::cx;
  static constexpr int channels = Plan::channels, lines = Shape::lines;
  using Basis = PointBasis<n, Real>;

  /// Folds the lines of points along x, in 3D.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_x(const Team& team, Real* t) {
    constexpr bool by_number = Room::by_number && (Channels::with_both == 0 || lines * Channels::folded <= Team::size);
    if constexpr (by_number) {
      share_known<lines * Channels::folded>(team,
                                            [&](int i) { number_along_x(t, quotient(i, lines), modulo(i, lines)); });
    } else {
      share_known<lines * channels>(team, [&](int i) { channel_along_x(t, quotient(i, lines), modulo(i, lines)); });
    }
  }

  /// In 3D, of folded lines. The planes that later passes add to stay with the team.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_y_and_z(const Team& team, int pass, bool last, Real* t, Real* out) {
    if constexpr (Room::columns * channels <= Team::size) {
      share_known<Room::columns * channels>(team, [&](int i) {
        const int c = quotient(i, Room::columns), column = modulo(i, Room::columns);
        column_along_y_and_z(t, pass, last, c, modulo(column, cx), quotient(column, cx), out);
      });
    } else {
      share_known<cx * channels>(
          team, [&](int i) { line_along_y_and_z(t, pass, last, quotient(i, cx), modulo(i, cx), out); });
    }
  }

  /// Folds along x in 2D. An item is control x of one channel.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void along_x_and_z(const Team& team, int pass, bool last, Real* t, Real* out) {
    share_known<cx * channels>(team, [&](int i) {
      const int c = quotient(i, cx), x = modulo(i, cx);
      const Real* const from = t + Room::integrands + Room::integrand(c);
      of_kind(c, [&](auto value, auto flux) {
        Real sum[QL][1][numbers] = {};
        SOFTWET_UNROLL
        for (int a = P; a >= 0; --a) {
          const int e = x - a;
          if (e < 0 || e >= Shape::NX) continue;
          SOFTWET_UNROLL
          for (int q = e * Q; q < e * Q + Q; ++q) SOFTWET_UNROLL
          for (int z = 0; z < QL; ++z)
            add<value(), flux()>(Basis::at(t + Room::x, q, a), from + z * Shape::qx + q, sum[z][0]);
        }
        along_z(t, pass, last, c, x, sum, out);
      });
    });
  }

  /// The planes of layers outside of the region are zero.
  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void clear(const Team& team, int passes, Real* out) {
    if (Shape::Shared || passes == Shape::NZ) return;
    const int done = (passes + P) * Room::columns, left = Shape::controls - done;
    share(team, left, [&](int i) {
      SOFTWET_UNROLL
      for (int c = 0; c < channels; ++c) out[c * Shape::controls + done + i] = Real(0);
    });
  }

 private:
  /// Numbers of a column that was folded along the other axes: against values, and against slopes along the last axis.
  static constexpr int numbers = Channels::all_fluxes > 0 ? 2 : 1;

  /// body(whether channel c has an integrand against values, whether it has fluxes), as types.
  template <class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void of_kind(int c, const Body& body) {
    using Yes = std::true_type;
    using No = std::false_type;
    constexpr int with_both = Channels::with_both;
    if constexpr (Channels::alike) {
      body(std::bool_constant<(Channels::all_values > 0)>(), std::bool_constant<(Channels::all_fluxes > 0)>());
    } else if (Channels::fluxes_before(c + 1) == Channels::fluxes_before(c)) {
      body(Yes(), No());
    } else if (with_both == 0 || Channels::values_before(c + 1) == Channels::values_before(c)) {
      body(No(), Yes());
    } else if constexpr (with_both > 0) {
      body(Yes(), Yes());
    }
  }

  /// Folds all numbers of a channel along x.
  static KOKKOS_FORCEINLINE_FUNCTION void channel_along_x(Real* t, int c, int line) {
    const Real* const from = t + Room::integrands + Room::integrand(c) + line;
    Real* const to = t + Room::folded + Channels::folded_before(c) * Room::folded_apart + line * cx;
    of_kind(c, [&](auto value, auto flux) {
      constexpr int sums = flux() ? D : 1;
      Real sum[cx][sums] = {};
      SOFTWET_UNROLL
      for (int q = 0; q < Shape::qx; ++q) SOFTWET_UNROLL
      for (int a = 0; a < n; ++a)
        add<value(), flux()>(Basis::at(t + Room::x, q, a), from + Room::place(q) * lines, sum[q / Q + a]);
      SOFTWET_UNROLL
      for (int d = 0; d < sums; ++d) SOFTWET_UNROLL
      for (int x = 0; x < cx; ++x) to[d * Room::folded_apart + x] = sum[x][d];
    });
  }

  /// Folded number k.
  static KOKKOS_FORCEINLINE_FUNCTION void number_along_x(Real* t, int k, int line) {
    const Real* const from = t + Room::integrands + Channels::first_of(k) * Room::number + line;
    const Real* const table = t + Room::x + (Channels::kind_of(k) == Channels::of_slopes ? 1 : 0);
    const bool slopes_too = Channels::with_both > 0 && Channels::kind_of(k) == Channels::of_both;
    Real sum[cx] = {};
    SOFTWET_UNROLL
    for (int q = 0; q < Shape::qx; ++q) SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) {
      Real& s = sum[q / Q + a];
      s = s + table[2 * (q * n + a)] * from[Room::place(q) * lines];
      if (slopes_too) s = s + table[2 * (q * n + a) + 1] * from[Room::number + Room::place(q) * lines];
    }
    Real* const to = t + Room::folded + k * Room::folded_apart + line * cx;
    SOFTWET_UNROLL
    for (int x = 0; x < cx; ++x) to[x] = sum[x];
  }

  /// The lines at one place along x, of one channel.
  static KOKKOS_FORCEINLINE_FUNCTION void line_along_y_and_z(Real* t, int pass, bool last, int c, int x, Real* out) {
    const Real* const from = t + Room::folded + Channels::folded_before(c) * Room::folded_apart + x;
    Real sum[QL][Shape::cy][numbers] = {};
    of_kind(c, [&](auto, auto flux) {
      SOFTWET_UNROLL
      for (int y = 0; y < Shape::qy; ++y) SOFTWET_UNROLL
      for (int a = 0; a < n; ++a) SOFTWET_UNROLL
      for (int z = 0; z < QL; ++z)
        add_across<flux()>(Basis::at(t + Room::y, y, a), from + line_of(z, y / Q, y % Q) * cx, sum[z][y / Q + a]);
    });
    along_z(t, pass, last, c, x, sum, out);
  }

  /// Control (x, y) of one channel.
  static KOKKOS_FORCEINLINE_FUNCTION void column_along_y_and_z(Real* t, int pass, bool last, int c, int x, int y,
                                                               Real* out) {
    const Real* const from = t + Room::folded + Channels::folded_before(c) * Room::folded_apart + x;
    Real sum[QL][1][numbers] = {};
    of_kind(c, [&](auto, auto flux) {
      SOFTWET_UNROLL
      for (int e = 0; e < Shape::NY; ++e) {
        const int a = y - e;
        if (a < 0 || a > P) continue;
        SOFTWET_UNROLL
        for (int q = 0; q < Q; ++q) SOFTWET_UNROLL
        for (int z = 0; z < QL; ++z)
          add_across<flux()>(Basis::at(t + Room::y, e * Q + q, a), from + line_of(z, e, q) * cx, sum[z][0]);
      }
    });
    along_z(t, pass, last, c, y * cx + x, sum, out);
  }

  /// The line along x of point q of element e across, as in PointNumbers.
  static KOKKOS_FORCEINLINE_FUNCTION int line_of(int z, int e, int q) { return z * Shape::qy + q * Shape::NY + e; }

  /// Adds what a point has along the first axis: from[number * Room::number].
  template <bool value, bool flux, int sums>
  static KOKKOS_FORCEINLINE_FUNCTION void add(const ValueAndSlope<Real>& basis, const Real* from, Real (&sum)[sums]) {
    if constexpr (value) sum[0] = sum[0] + basis.value * from[0];
    if constexpr (flux) {
      const Real* const along = from + (value ? Room::number : 0);
      sum[0] = sum[0] + basis.slope * along[0];
      SOFTWET_UNROLL
      for (int d = 1; d < D; ++d) sum[d] = sum[d] + basis.value * along[d * Room::number];
    }
  }

  /// Adds what a line along x has across: from[number * folded_apart].
  template <bool flux, int sums>
  static KOKKOS_FORCEINLINE_FUNCTION void add_across(const ValueAndSlope<Real>& basis, const Real* from,
                                                     Real (&sum)[sums]) {
    sum[0] = sum[0] + basis.value * from[0];
    if constexpr (flux) {
      sum[0] = sum[0] + basis.slope * from[Room::folded_apart];
      sum[1] = sum[1] + basis.value * from[2 * Room::folded_apart];
    }
  }

  /// Folds `count` columns of channel c, the first one at `column`, along the last axis: folded[z][column][against
  /// values, against slopes]. A plane of control values that no later pass reaches goes to `out`,
  /// [channel][plane][column] of the tile. The others, which the same thread adds to in the next pass, stay with the
  /// team.
  template <int count>
  static KOKKOS_FORCEINLINE_FUNCTION void along_z(Real* t, int pass, bool last, int c, int column,
                                                  const Real (&folded)[QL][count][numbers], Real* out) {
    constexpr bool shared = Shape::Shared;
    constexpr int columns = Room::columns;
    Real* const kept = t + Room::sums + c * Room::channel_sums + column;
    Basis basis[QL];
    SOFTWET_UNROLL
    for (int q = 0; q < QL; ++q) basis[q] = Basis(t + Room::test, pass * QL + q);
    Real sum[n][count];
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) SOFTWET_UNROLL
    for (int y = 0; y < count; ++y) {
      sum[a][y] = pass > 0 && (shared || a < P) ? kept[a * columns + y * cx] : Real(0);
      SOFTWET_UNROLL
      for (int q = 0; q < QL; ++q) {
        sum[a][y] = sum[a][y] + basis[q].value[a] * folded[q][y][0];
        if constexpr (numbers > 1) sum[a][y] = sum[a][y] + basis[q].slope[a] * folded[q][y][1];
      }
    }
    Real* const to = out + c * Shape::controls + (shared ? 0 : pass * columns) + column;
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) SOFTWET_UNROLL
    for (int y = 0; y < count; ++y)
      if (last || (!shared && a == 0)) {
        to[a * columns + y * cx] = sum[a][y];
      } else {
        kept[(shared ? a : a - 1) * columns + y * cx] = sum[a][y];
      }
  }
};

}  // namespace softwet
