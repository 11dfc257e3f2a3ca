// The kernel of a device for terms with fewer than degree + 1 points along an axis, or of means over elements: slopes
// do not follow from values there, so that a tile sweeps them too. As in tile.hpp elements share all sums along the
// other axes.
#pragma once

#include "operator/device/slope_folds.hpp"
#include "operator/device/slope_sweeps.hpp"
#include "operator/device/tile_point.hpp"

namespace softwet {

/// Fields at one point, as Reader wants them.
template <class Plan>
struct SlopeFields {
  using S = typename Plan::S;
  static constexpr int D = Plan::D;
  static constexpr int place(int f) { return f + D * Plan::stored_before(f); }  ///< of a value; slopes are behind it
  typename Plan::Real at[place(Plan::fields)];
  const typename Plan::Real* scale;

  KOKKOS_FORCEINLINE_FUNCTION S part(int field, int c) const { return S(at[place(field) + c]); }
  KOKKOS_FORCEINLINE_FUNCTION typename Plan::N number(int s, int c, int) const {
    if constexpr (Plan::Tangent) {
      const int unknown = Plan::unknown_of_slot(s);
      return {part(s, c), unknown < D + 2 ? S(scale[s]) * part(Plan::tangent_of(unknown), c) : S(0.0)};
    } else {
      return part(s, c);
    }
  }
};

/// Takes the integrands of a point to the memory of the team, but for those that a channel does not have.
template <class Plan>
struct SlopeSink {
  using S = typename Plan::S;
  using Room = SlopeRooms<Plan>;
  using Channels = typename Room::Channels;
  typename Plan::Real* to;  ///< at this point

  KOKKOS_FORCEINLINE_FUNCTION void integrand(int channel, const S& number) {
    if (Channels::has_value(channel)) to[Room::integrand(channel)] = plain(number);
  }
  KOKKOS_FORCEINLINE_FUNCTION void flux(int channel, int d, const S& number) {
    const int before = Channels::has_value(channel) ? 1 : 0;
    if (Channels::has_flux(channel)) to[Room::integrand(channel) + (before + d) * Room::number] = plain(number);
  }
};

/// A term on the tiles of a region.
template <class Plan>
struct SlopeTile : TilePoints<Plan, SlopeScratch<Plan>> {
  using Base = TilePoints<Plan, SlopeScratch<Plan>>;
  using typename Base::Real;
  using typename Base::Room;
  using typename Base::Shape;
  using Sweeps = SlopeSweeps<Plan>;
  using Folds = SlopeFolds<Plan>;
  using Fields = SlopeFields<Plan>;
  using Base::D, Base::Q, Base::P, Base::n, Base::task, Base::grid;

  void set_spacing(const double (&)[D]) {}

  /// What the sweeps need to know of control values and functions.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load(const Team& team, const int (&corner)[D], Real* t) const {
    constexpr int y = Shape::qx, z = y + (D == 3 ? Shape::qy : 0), test = z + Room::zs, all = test + Room::zs;
    share_known<all>(team, [&](int i) {
      const int axis = i < y ? 0 : i < z ? 1 : i < test ? D - 1 : D;
      load_point(axis < D ? task.axis[axis] : task.test, axis < D ? axis : D - 1, corner, i,
                 i - (axis == 0  ? 0
                      : i < z    ? y
                      : i < test ? z
                                 : test),
                 i < test, t);
    });
    load_places(team, corner, Sweeps::places(t));
  }

  /// Point q of an axis within a tile, the i-th of all.
  KOKKOS_FORCEINLINE_FUNCTION void load_point(const AxisTables<Real>& rule, int d, const int (&corner)[D], int i, int q,
                                              bool trial, Real* t) const {
    const int each = Shape::QL == Q || d < D - 1 ? Q : Shape::QL, at = modulo(q, each);
    const int e = (d == 0 ? corner[0] : d == D - 1 ? corner[D - 1] : corner[D - 2]) + quotient(q, each);
    const int low = d == 0 ? grid.lead : 0, end = grid.elements[d];
    const int known = grid.first[d] + Base::within(low, e, end - 1);
    auto* const to = reinterpret_cast<ValueAndSlope<Real>*>(t + Room::x) + i * n;
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) to[a] = {rule.value(at, a, known), rule.slope(at, a, known)};
    if (!trial) return;
    t[Room::x_weight + i] = e >= low && e < end ? rule.weight(at, known) : Real(0);
    t[Room::x_place + i] = rule.position(at, known);
  }

  /// The integers of Room::places.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_places(const Team& team, const int (&corner)[D], int* places) const {
    share_known<Room::integers, Base::warps_apart>(team, [&](int i) {
      if (i < Room::y_places) {
        places[i] = grid.first[0] + Base::within(grid.lead, corner[0] + i, grid.elements[0] + P - 1);
      } else if (i >= Room::z_places) {
        places[i] = this->place_along(D - 1, corner[D - 1] + i - Room::z_places);
      } else {
        places[i] = this->place_along(1, corner[1] + i - Room::y_places);
      }
    });
  }

  /// The last sweep, along x: fields at points q, q + 1, ... of element e along x, on line `line` of a pass.
  template <int count>
  static KOKKOS_FORCEINLINE_FUNCTION void read(const Real* t, int e, int q, int line, Fields (&fields)[count]) {
    PointBasis<n, Real> basis[count];
    SOFTWET_UNROLL
    for (int i = 0; i < count; ++i) basis[i] = PointBasis<n, Real>(t + Room::x, e * Q + q + i);
    const Real* const from = t + line * Shape::cx + e;
    for_each_index<Plan::fields>([&](auto f) {
      SOFTWET_UNROLL
      for (int c = 0; c < (Plan::has_gradient(f()) ? D : 1); ++c) {
        Real control[n];
        SOFTWET_UNROLL
        for (int a = 0; a < n; ++a) control[a] = from[Sweeps::swept(f()) + c * Room::apart + a];
        SOFTWET_UNROLL
        for (int i = 0; i < count; ++i) {
          Real* const to = fields[i].at + Fields::place(f());
          to[c > 0 ? c + 1 : 0] = basis[i].sum(basis[i].value, control, 1);
          if (c == 0 && Plan::has_gradient(f())) to[1] = basis[i].sum(basis[i].slope, control, 1);
        }
      }
    });
  }

  /// The term at these points.
  template <int count>
  KOKKOS_FORCEINLINE_FUNCTION void evaluate_at(int e, int q, int line, int pass, const int (&corner)[D],
                                               Real* t) const {
    Fields fields[count];
    read(t, e, q, line, fields);
    SOFTWET_UNROLL
    for (int i = 0; i < count; ++i) {
      fields[i].scale = task.scale;
      const int p = D == 3 ? ((q + i) * Shape::NX + e) * Shape::lines + line : line * Shape::qx + e * Q + q + i;
      this->evaluate(p, pass, corner, t, fields[i],
                     [&](int again) { return SlopeSink<Plan>{t + Room::integrands + again}; });
    }
  }

  /// Evaluates the points of a pass: each thread has one or, where there are too few threads, all points of an element
  /// on a line.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void evaluate_all(const Team& team, int pass, const int (&corner)[D], Real* t) const {
    constexpr int several = Team::size * Q <= Shape::points ? Q : 1, along = Shape::qx / several;
    share_points<Shape::points / several>(team, [&](int i, int) {
      const int line = D == 3 ? modulo(i, Shape::lines) : quotient(i, along);
      const int x = D == 3 ? quotient(i, Shape::lines) : modulo(i, along);
      if constexpr (several > 1) {
        evaluate_at<several>(x, 0, line, pass, corner, t);
      } else if constexpr (D == 3) {
        evaluate_at<1>(modulo(x, Shape::NX), quotient(x, Shape::NX), line, pass, corner, t);
      } else {
        evaluate_at<1>(quotient(x, Q), modulo(x, Q), line, pass, corner, t);
      }
    });
  }

  /// Runs one pass: a layer of elements, added to the sums of the tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_pass(const Team& team, int pass, bool last, int (&corner)[D],
                                            const Real* direction, Real* t) const {
    const SlopeTile* const self = anew(this);
    Sweeps::across(team, pass, t, [&](int f) {
      if constexpr (Plan::Tangent)
        if (f >= Plan::slots) return direction + self->task.tangents.of_unknown[Plan::unknown_of(f)];
      return self->task.slot[f];
    });
    team.barrier();
    evaluate_all(team, pass, corner, t);
    team.barrier();
    if constexpr (D == 3) {
      Folds::along_x(team, t);
      team.barrier();
      Folds::along_y_and_z(team, pass, last, t, this->partial_of(team));
      team.barrier();
    } else {
      Folds::along_x_and_z(team, pass, last, t, this->partial_of(team));
    }
  }

  /// @param direction  of a product
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Real* direction, Real* t) const {
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    load(team, corner, t);
    team.barrier();
    this->load_blend(team, t);
    if constexpr (Plan::moves) Sweeps::trace(team, t, [&](int f) { return this->of_wall(f, direction); });
    const int passes = this->passes(corner);
    for (int pass = 0; pass < passes; ++pass) {
      run_pass(team, pass, pass == passes - 1, corner, direction, t);
      ++corner[D - 1];
    }
    Folds::clear(team, passes, this->partial_of(team));
  }
};

}  // namespace softwet
