// The kernel of a device: a team of threads takes a tile of elements through a term, one thread for each point of a pass.
//
// Elements of a tile share the sweeps of values along the axes. Slopes follow from the values at the points of an element, and
// on the way back fluxes turn into integrands against values in the same way. A tile writes the control values that it sums,
// with those it shares with other tiles; `collect.hpp` adds them up. So no point is computed twice, nothing is written by
// two threads, and results are the same bits for any team and any order of tiles.
#pragma once

#include "operator/device/tile_motion.hpp"
#include "operator/device/tile_sweeps.hpp"
#include "operator/device/tile_task.hpp"

namespace softwet {

/// What a point keeps between two barriers: registers on a device.
template <class Plan>
struct PointState {
  using Real = typename Plan::Real;
  Real value[Plan::fields];                       ///< of fields without gradients
  Real across[Plan::on_wall ? Plan::fields : 1];  ///< slopes across a wall
  Real integrand[Plan::channels];
};

/// Fields at one point, as Reader wants them.
template <class Plan>
struct TileFields {
  using Shape = typename Plan::Shape;
  using Real = typename Plan::Real;
  using S = typename Plan::S;
  static constexpr int D = Shape::D, Q = Shape::Q;
  const PointState<Plan>& own;
  const Real* values;  ///< of fields with gradients, at this point
  const Real (&row)[D][Q];
  const int (&step)[D][Q];
  const Real* scale;

  KOKKOS_FORCEINLINE_FUNCTION S part(int field, int c) const {
    if (!Plan::has_gradient(field)) return S(own.value[field]);
    const Real* v = values + Plan::stored_before(field) * Shape::points;
    if (c == 0) return S(v[0]);
    if (c > Plan::collocated) return S(own.across[field]);
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

/// What Test::write sees.
template <class Plan, class Point>
struct TileWriter {
  using N = typename Plan::N;
  using S = typename Plan::S;
  static constexpr int D = Plan::D;
  PointState<Plan>& own;
  typename Plan::Real* flux;  ///< [channel][d][point], at this point
  const Point& point;
  S weight;
  S share[D];  ///< of the element along each axis

  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value) const {
    own.integrand[channel] = plain(weight * outcome(point.measured(value)));
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& f) const {
    add(channel, value);
    add_flux(channel, f);
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& f, const N& hoop) const {
    own.integrand[channel] = plain(weight * outcome(point.measured(value, hoop)));
    add_flux(channel, f);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void add_flux(int channel, const Vector<N, D>& f) const {
    const Vector<N, D> r = point.reference_flux(f);
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d)
      flux[(channel * D + d) * Plan::Shape::points] = plain(weight * outcome(r[d]) * share[d]);
  }
};

/// A term on the tiles of a region.
template <class Plan>
struct Tile {
  using Shape = typename Plan::Shape;
  using Room = TileScratch<Plan>;
  using Sweeps = TileSweeps<Plan>;
  using Real = typename Plan::Real;
  using S = typename Plan::S;
  using N = typename Plan::N;
  static constexpr int D = Shape::D, P = Shape::P, n = Shape::n, Q = Shape::Q;

  TileTask<Plan> task;
  Collocation<D, Q, Real> slope;
  TileGrid<D> grid;
  Real* partial;  ///< [tile][channel][plane][cy][cx]

  static KOKKOS_FORCEINLINE_FUNCTION int least(int a, int b) { return a < b ? a : b; }
  static KOKKOS_FORCEINLINE_FUNCTION int within(int low, int i, int high) { return i < low ? low : least(i, high); }

  /// Place in the wall's row of control (i, j) from the corner of a tile; outside of the region it repeats the nearest one.
  KOKKOS_FORCEINLINE_FUNCTION int column(const int (&corner)[D], int i, int j) const {
    int at = grid.first[0] + within(grid.lead, corner[0] + i, grid.elements[0] + P - 1);
    if constexpr (D == 3) at += least(corner[1] + j, grid.elements[1] + P - 1) * task.stride[1];
    return at;
  }
  KOKKOS_FORCEINLINE_FUNCTION int control(const int (&corner)[D], int i, int j, int k) const {
    const int row = task.axis[D - 1].first_functions[0] + least(corner[D - 1] + k, grid.elements[D - 1] + P - 1);
    return column(corner, i, j) + row * task.stride[D - 1];
  }

  /// Tables of an axis for the elements of a tile; those outside of the region have no weight.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_axis(const Team& team, const AxisTables<Real>& rule, int d, int corner,
                                             int count, Real* basis, Real* weight, Real* place, Real* element) const {
    const int each = d == D - 1 ? Shape::QL : Q;
    share(team, count * each, [&](int i) {
      const int e = corner + i / each, q = i % each, low = d == 0 ? grid.lead : 0;
      const int known = grid.first[d] + within(low, e, grid.elements[d] - 1);
      for (int a = 0; a < n; ++a) basis[i * n + a] = rule.value(q, a, known);
      if (!weight) return;
      weight[i] = e >= low && e < grid.elements[d] ? rule.weight(q, known) : Real(0);
      place[i] = rule.position(q, known);
      if (q == 0) element[i / each] = rule.share(known);
    });
  }
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_tables(const Team& team, const int (&corner)[D], Real* t) const {
    load_axis(team, task.axis[0], 0, corner[0], Shape::NX, t + Room::x, t + Room::x_weight, t + Room::x_place,
              t + Room::x_share);
    if constexpr (D == 3)
      load_axis(team, task.axis[1], 1, corner[1], Shape::NY, t + Room::y, t + Room::y_weight, t + Room::y_place,
                t + Room::y_share);
    constexpr int last = D - 1;
    load_axis(team, task.axis[last], last, corner[last], Shape::NZ, t + Room::z, t + Room::z_weight, t + Room::z_place,
              t + Room::z_share);
    load_axis(team, task.test, last, corner[last], Shape::NZ, t + Room::test, nullptr, nullptr, nullptr);
    if constexpr (Plan::on_wall) share(team, n, [&](int a) { t[Room::z_slope + a] = task.axis[last].slope(0, a, 0); });
  }

  /// Where the share of the element of point p along axis d stands.
  static KOKKOS_FORCEINLINE_FUNCTION int share_place(int p, int pass, int d) {
    if (d == 0) return Room::x_share + p % Shape::qx / Q;
    if (d == 1 && D == 3) return Room::y_share + p / Shape::qx % Shape::qy / Q;
    return Room::z_share + (pass * Shape::qz + p / Shape::base) / Shape::QL;
  }

  /// Point p of a pass with what it remembers. @param corner  of the pass; elements outside of the region have the memory of the
  /// nearest one, and no weight
  template <class Point>
  KOKKOS_FORCEINLINE_FUNCTION auto with_memory_of(const Point& point, int p, const int (&corner)[D]) const {
    if constexpr (memory_size_of<typename Plan::Trial> == 0) {
      return point;
    } else {
      static_assert(Shape::QL == Q, "points of a volume remember");
      const int at[3] = {p % Shape::qx, D == 3 ? p / Shape::qx % Shape::qy : p / Shape::base, p / Shape::base};
      Batch<D> b{};
      b.count = 1;
      int q = 0;
      for (int d = D - 1; d >= 0; --d) {
        const int e = corner[d] + at[d] / Q, low = d == 0 ? grid.lead : 0;
        b.element[d] = grid.first[d] + within(low, e, grid.elements[d] - 1);
        q = q * Q + at[d] % Q;
      }
      return with_memory<typename Plan::Trial, Q, S>(point, task.memory, task.stride, grid.elements[1], b, q);
    }
  }

  /// The term at point p of a pass.
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int p, int pass, const int (&corner)[D], const Real* t, Real* values,
                                            Real* flux, PointState<Plan>& own) const {
    int q[D], step[D][Q];
    Real row[D][Q];
    Sweeps::neighbours(p, q, step);
    const int x = p % Shape::qx, y = p / Shape::qx % Shape::qy, z = pass * Shape::qz + p / Shape::base;
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) SOFTWET_UNROLL
    for (int r = 0; r < Q; ++r) row[d][r] = slope.forward[d][q[d]][r] * t[share_place(p, pass, d)];
    Vector<S, D> reference;
    reference[0] = S(t[Room::x_place + x]);
    if constexpr (D == 3) reference[1] = S(t[Room::y_place + y]);
    const Real height = t[Room::z_place + z];
    reference[D - 1] = S(height);
    const auto place =
        in_coordinates<typename Plan::Term>(point_above_wall<N, Shape::base, Plan::on_wall>(
                                                task.motion, t + Room::wall + p % Shape::base, reference, height),
                                            reference);
    const auto point = with_memory_of(place, p, corner);
    using Point = std::remove_const_t<decltype(point)>;
    const TileFields<Plan> from{own, values + p, row, step, task.scale};
    using From = Reader<N, D, TileFields<Plan>, Point>;
    const auto test = task.term.residual(Plan::Trial::read(From{from, point, 0}));
    const int again = anew(p);  // what was derived from p has been given up
    Real weight = task.factor * t[Room::x_weight + again % Shape::qx] *
                  t[Room::z_weight + pass * Shape::qz + again / Shape::base];
    if constexpr (D == 3) weight = weight * t[Room::y_weight + again / Shape::qx % Shape::qy];
    TileWriter<Plan, Point> writer{own, flux + again, point, S(weight), {}};
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) writer.share[d] = S(t[share_place(again, pass, d)]);
    test.write(writer);
  }

  /// One pass: L layers of elements, added to the sums of the tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_pass(const Team& team, int pass, const Real* direction, Real* t) const {
    PointState<Plan> own[(Shape::points + Team::size - 1) / Team::size];  // points of a thread: one on a device
    Real *const first = t + Room::first, *const second = t + Room::second;
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    corner[D - 1] += pass * Shape::L;
    Sweeps::along_x(
        team, t, D == 3 ? first : second, [&](int i, int j, int k) { return control(corner, i, j, k); },
        [&](auto f) {
          if constexpr (f() < Plan::slots) {
            return task.slot[f()];
          } else {
            return direction + task.tangents.of_unknown[Plan::unknown_of(f())];
          }
        });
    team.barrier();
    if constexpr (D == 3) {
      Sweeps::along_y(team, t, first, second);
      team.barrier();
    }
    share_points<Shape::points>(team, [&](int p, int l) { Sweeps::along_z(p, pass, t, second, first, own[l]); });
    team.barrier();
    share_points<Shape::points>(team, [&](int p, int l) { evaluate(p, pass, corner, t, first, second, own[l]); });
    team.barrier();
    share_points<Shape::points>(team,
                                [&](int p, int l) { Sweeps::fold_fluxes(slope, p, second, own[l].integrand, first); });
    team.barrier();
    Sweeps::fold_z(team, pass, t, first, second);
    team.barrier();
    if constexpr (D == 3) {
      Sweeps::fold_y(team, t, second, second + Room::folded_z);
      team.barrier();
    }
    Sweeps::fold_x(team, pass, t, D == 3 ? second + Room::folded_z : second, t + Room::sums);
    team.barrier();
  }

  /// Field f of the wall's motion; null where it is zero.
  KOKKOS_FORCEINLINE_FUNCTION const Real* of_wall(int f, const Real* direction) const {
    if (f < D) return task.motion.displacement[f];
    if (f < 2 * D) return task.motion.velocity[f - D];
    return task.tangents.moves ? direction + task.tangents.of_wall[f - 2 * D] : nullptr;
  }

  /// @param direction  of a product
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Real* direction, Real* t) const {
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    load_tables(team, corner, t);
    constexpr int sums = Plan::channels * Shape::controls;
    share(team, sums, [&](int i) { t[Room::sums + i] = 0; });
    team.barrier();
    if constexpr (Plan::moves)
      TileMotion<Plan>::trace(
          team, slope, t, [&](int i, int j) { return column(corner, i, j); },
          [&](int f) { return of_wall(f, direction); });
    const int passes = least(Shape::M, (grid.elements[D - 1] - corner[D - 1] + Shape::L - 1) / Shape::L);
    for (int pass = 0; pass < passes; ++pass) run_pass(team, pass, direction, t);
    share(team, sums, [&](int i) { partial[std::int64_t(team.tile()) * sums + i] = t[Room::sums + i]; });
  }
};

}  // namespace softwet
