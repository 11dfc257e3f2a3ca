// The kernel of a device: a team of threads takes a tile of elements through a term, one thread for each point of a
// pass.
//
// Elements of a tile share the sweeps of values along the axes. Slopes follow from the values at the points of an
// element, and on the way back fluxes turn into integrands against values in the same way. A tile writes the control
// values that it sums, with those it shares with other tiles; `collect.hpp` adds them up. So no point is computed
// twice, nothing is written by two threads, and results are the same bits for any team and any order of tiles.
#pragma once

#include "operator/device/tile_motion.hpp"
#include "operator/device/tile_point.hpp"
#include "operator/device/tile_sweeps_3d.hpp"

namespace softwet {

/// So many axes, the first ones, along which a point folds fluxes. In 3D the fold along the other axes does it for
/// them, since it has all points of an element in registers.
template <class Plan>
inline constexpr int fold_axes = Plan::D == 3 ? 1 : Plan::collocated;

/// What a point keeps between two barriers: registers on a device. In 3D `value` and `across` are in memory instead.
template <class Plan>
struct PointState {
  using Real = typename Plan::Real;
  Real value[Plan::fields];                       ///< of fields without gradients
  Real across[Plan::on_wall ? Plan::fields : 1];  ///< slopes across a wall
  Real integrand[Plan::channels];
  Real flux[Plan::channels][fold_axes<Plan>];  ///< along the first axes
};

/// Fields at one point, as Reader wants them.
template <class Plan>
struct TileFields {
  using Shape = typename Plan::Shape;
  using Real = typename Plan::Real;
  using S = typename Plan::S;
  using Room = TileScratch<Plan>;
  static constexpr int D = Shape::D, Q = Shape::Q;
  const PointState<Plan>& own;
  const Real* values;  ///< of fields with gradients, at this point
  const Real (&row)[D][Q];
  const int (&step)[D][Q];
  const Real* scale;

  /// Number i that a point keeps, behind its values in 3D.
  KOKKOS_FORCEINLINE_FUNCTION Real kept(int i) const { return values[Room::kept + i * Room::point_field]; }
  KOKKOS_FORCEINLINE_FUNCTION S part(int field, int c) const {
    if (!Plan::has_gradient(field)) return S(D == 3 ? kept(field - Plan::stored_before(field)) : own.value[field]);
    const Real* v = values + Plan::stored_before(field) * Room::point_field;
    if (c == 0) return S(v[0]);
    if (c > Plan::collocated) return S(D == 3 ? kept(Room::across + field) : own.across[field]);
    Real sum = row[c - 1][0] * v[0];
    SOFTWET_UNROLL
    for (int r = 1; r < Q; ++r) sum = sum + row[c - 1][r] * v[step[c - 1][r]];
    return S(sum);
  }
  KOKKOS_FORCEINLINE_FUNCTION typename Plan::N number(int s, int c, int) const {
    if constexpr (Plan::Tangent) {
      const int unknown = Plan::unknown_of_slot(s);
      return {part(s, c), unknown < D + 2 ? S(scale[s]) * part(Plan::tangent_of(unknown), c) : S(0.0)};
    } else {
      return part(s, c);
    }
  }
};

/// Takes the integrands of a point: those against values stay with it, fluxes go to the memory of the team.
template <class Plan>
struct TileSink {
  using S = typename Plan::S;
  using Real = typename Plan::Real;
  using Room = TileScratch<Plan>;
  static constexpr int D = Plan::D, axes = fold_axes<Plan>;
  PointState<Plan>& own;
  Real* to;    ///< fluxes along the first axes [channel][d][point], at this point
  Real* rest;  ///< along the others [d][channel][point]
  S share[D];  ///< of the element along each axis

  KOKKOS_FORCEINLINE_FUNCTION void integrand(int channel, const S& number) { own.integrand[channel] = plain(number); }
  KOKKOS_FORCEINLINE_FUNCTION void flux(int channel, int d, const S& number) {
    const Real scaled = plain(number * share[d]);
    if (d < axes) {
      own.flux[channel][d] = to[(channel * axes + d) * Room::point_field] = scaled;
    } else if (d < Plan::collocated) {
      rest[(d - axes) * Room::of_flux + channel * Room::point_field] = scaled;
    }
  }
};

/// A term on the tiles of a region, whose slopes follow from values.
template <class Plan>
struct Tile : TilePoints<Plan, TileScratch<Plan>> {
  using Base = TilePoints<Plan, TileScratch<Plan>>;
  using typename Base::Real;
  using typename Base::Room;
  using typename Base::S;
  using typename Base::Shape;
  using Sweeps = TileSweeps<Plan>;
  using Sweeps3D = TileSweeps3D<Plan>;
  using Base::D, Base::Q, Base::task, Base::grid;

  Collocation<D, Q, Real> slope;

  void set_spacing(const double (&spacing)[D]) { slope = Collocation<D, Q, Real>::of(spacing); }

  /// Where the share of the element of point p along axis d stands.
  static KOKKOS_FORCEINLINE_FUNCTION int share_place(int p, int pass, int d) {
    if (d == 0) return Room::x_share + quotient(modulo(p, Shape::qx), Q);
    if (d == 1 && D == 3) return Room::y_share + quotient(modulo(quotient(p, Shape::qx), Shape::qy), Q);
    return Room::z_share + pass * Shape::L + Sweeps::layer(p);
  }

  /// Where the row of point p along axis d stands.
  static KOKKOS_FORCEINLINE_FUNCTION int row_place(int p, int pass, int d) {
    if (d == 0) return Room::x_row + modulo(p, Shape::qx) * Q;
    if (d == 1 && D == 3) return Room::y_row + modulo(quotient(p, Shape::qx), Shape::qy) * Q;
    return Room::z_row + (pass * Shape::qz + quotient(p, Shape::base)) * Q;
  }
  /// The rows, when the shares are there.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_rows(const Team& team, Real* t) const {
    if constexpr (Room::knows_rows) {
      load_rows_along<0>(team, Shape::qx, t + Room::x_row, t + Room::x_share);
      if constexpr (D == 3) load_rows_along<1>(team, Shape::qy, t + Room::y_row, t + Room::y_share);
      if constexpr (!Plan::on_wall)
        load_rows_along<D - 1>(team, Shape::QL * Shape::NZ, t + Room::z_row, t + Room::z_share);
    }
  }
  template <int d, class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_rows_along(const Team& team, int count, Real* row, const Real* element) const {
    share_from(team, (1 + d) * Base::warps_apart, count * Q, [&](int i) {
      const int at = quotient(i, Q);
      row[i] = slope.forward[d][modulo(at, Q)][modulo(i, Q)] * element[quotient(at, Q)];
    });
  }

  /// The term at point p of a pass.
  KOKKOS_FORCEINLINE_FUNCTION void evaluate_at(int p, int pass, const int (&corner)[D], Real* t,
                                               PointState<Plan>& own) const {
    int q[D], step[D][Q];
    Real row[D][Q];
    Sweeps::neighbours(p, q, step);
    SOFTWET_UNROLL
    for (int d = 0; d < Plan::collocated; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r)
      row[d][r] =
          Room::knows_rows ? t[row_place(p, pass, d) + r] : slope.forward[d][q[d]][r] * t[share_place(p, pass, d)];
    this->evaluate(p, pass, corner, t, TileFields<Plan>{own, t + Room::first + p, row, step, task.scale},
                   [&](int again) {
                     TileSink<Plan> to{own, t + fluxes + again, t + Room::flux + again, {}};
                     SOFTWET_UNROLL
                     for (int d = 0; d < D; ++d) to.share[d] = S(t[share_place(again, pass, d)]);
                     return to;
                   });
  }

  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void sweep_x(const Team& team, int pass, const Real* direction, const Real* t,
                                           Real* to) const {
    const Tile* const self = anew(this);
    Sweeps::along_x(team, pass, t, to, [&](auto f, int at) {
      if constexpr (f() < Plan::slots) {
        return self->task.slot[f()] + at;
      } else {
        return direction + (self->task.tangents.of_unknown[Plan::unknown_of(f())] + at);
      }
    });
  }
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void corner_of(const Team& team, int pass, int (&corner)[D]) const {
    grid.template corner<Shape>(team.tile(), corner);
    corner[D - 1] += pass * Shape::L;
  }
  template <class Team, class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void each_point(const Team& team, const Body& body) {
    share_points<Shape::points, Shape::lanes>(team, body);
  }
  template <class Team>  // points of a thread: one on a device
  static constexpr int own_points = (slots_of(Shape::points, Shape::lanes) + Team::size - 1) / Team::size;
  static constexpr int fluxes = D == 3 ? Room::flux_x : Room::second;  ///< along the first axes

  /// Runs one pass in 2D: L layers of elements, added to the sums of the tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_pass(const Team& team, int pass, const Real* direction, Real* t) const {
    PointState<Plan> own[own_points<Team>];
    Real *const first = t + Room::first, *const second = t + Room::second;
    int corner[D];
    corner_of(team, pass, corner);
    sweep_x(team, pass, direction, t, second);
    team.barrier();
    each_point(team, [&](int p, int l) { Sweeps::along_z(p, pass, t, second, first, own[l]); });
    team.barrier();
    each_point(team, [&](int p, int l) { evaluate_at(p, pass, corner, t, own[l]); });
    team.barrier();
    each_point(team, [&](int p, int l) {
      Sweeps::template fold_fluxes<fold_axes<Plan>>(*anew(&slope), p, second, own[l], first);
    });
    team.barrier();
    Sweeps::fold_z(team, pass, t, first, second);
    team.barrier();
    Sweeps::fold_x(team, pass, t, second, t + Room::sums);
    team.barrier();
  }

  /// The passes in 3D, a layer of elements each. While the last warps fold a pass, the first ones sweep the next one.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_passes(const Team& team, int passes, const Real* direction, Real* t) const {
    for (int pass = 0;; ++pass) {
      if (pass > 0) Sweeps3D::fold_z_and_y(team, pass - 1, *anew(&slope), t);
      if constexpr (Plan::tight) team.barrier();
      if (pass < passes) sweep_x(team, pass, direction, t, t + Room::swept);
      team.barrier();
      if (pass > 0) Sweeps3D::fold_x(team, pass - 1, t);
      if (pass == passes) return;
      Sweeps3D::along_y_and_z(team, pass, t);
      team.barrier();
      PointState<Plan> own[own_points<Team>]{};  // zeros: a thread without a point would keep its last state
      int corner[D];
      corner_of(team, pass, corner);
      each_point(team, [&](int p, int l) { evaluate_at(p, pass, corner, t, own[l]); });
      team.barrier();
      each_point(team, [&](int p, int l) { Sweeps::template fold_fluxes<1>(*anew(&slope), p, t + fluxes, own[l], t); });
      team.barrier();
    }
  }

  /// @param direction  of a product
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Real* direction, Real* t) const {
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    this->load_tables(team, corner, t);
    this->load_places(team, corner, Sweeps::places(t));
    share(team, Base::sums, [&](int i) { t[Room::sums + i] = 0; });
    team.barrier();
    load_rows(team, t);
    this->load_blend(team, t);
    if constexpr (Plan::moves)
      TileMotion<Plan>::trace(team, slope, t, [&](int f) { return this->of_wall(f, direction); });
    const int passes = this->passes(corner);
    if constexpr (D == 3) {
      run_passes(team, passes, direction, t);
      team.barrier();
    } else {
      for (int pass = 0; pass < passes; ++pass) run_pass(team, pass, direction, t);
    }
    share(team, Base::sums, [&](int i) { this->partial_of(team)[i] = t[Room::sums + i]; });
  }
};

}  // namespace softwet
