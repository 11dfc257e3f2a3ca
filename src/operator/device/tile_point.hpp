// What all tiles have: the task of a term, its tables in the memory of a team, and the term at one point.
#pragma once

#include "operator/device/tile_task.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

/// What Test::write sees. A sink takes the integrand of a channel against the values of test functions,
/// `integrand(channel, number)`, and those against their slopes, `flux(channel, axis, number)`.
template <class Plan, class Point, class Sink>
struct TileWriter {
  using N = typename Plan::N;
  using S = typename Plan::S;
  static constexpr int D = Plan::D;
  Sink& to;
  const Point& point;
  S weight;

  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value) const {
    to.integrand(channel, weight * outcome(point.measured(value)));
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& f) const {
    add(channel, value);
    add_flux(channel, f);
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& f, const N& hoop) const {
    to.integrand(channel, weight * outcome(point.measured(value, hoop)));
    add_flux(channel, f);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void add_flux(int channel, const Vector<N, D>& f) const {
    const Vector<N, D> r = point.reference_flux(f);
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) to.flux(channel, d, weight * outcome(r[d]));
  }
};

/// Point p of a pass along each axis, and among the points of the wall. Where sweeps make slopes in 3D, the points of
/// one place along x are adjacent, and neighbouring elements come before the points of an element, along x and across:
/// so neighbouring threads read and write neighbouring numbers.
template <class Shape>
struct PointNumbers {
  int x, y, z, wall;

  static KOKKOS_FORCEINLINE_FUNCTION PointNumbers of(int p) {
    if constexpr (Shape::own_slopes && Shape::D == 3) {
      const int place = quotient(p, Shape::lines), line = modulo(p, Shape::lines), across = modulo(line, Shape::qy);
      const int x = modulo(place, Shape::NX) * Shape::Q + quotient(place, Shape::NX);
      const int y = modulo(across, Shape::NY) * Shape::Q + quotient(across, Shape::NY);
      return {x, y, quotient(line, Shape::qy), place * Shape::qy + across};
    } else {
      return {modulo(p, Shape::qx), modulo(quotient(p, Shape::qx), Shape::qy), quotient(p, Shape::base),
              modulo(p, Shape::base)};
    }
  }
};

/// A term on the tiles of a region. Room says where a team keeps its tables.
template <class Plan_, class Room_>
struct TilePoints {
  using Plan = Plan_;
  using Room = Room_;
  using Shape = typename Plan::Shape;
  using Real = typename Plan::Real;
  using S = typename Plan::S;
  using N = typename Plan::N;
  static constexpr int D = Shape::D, P = Shape::P, n = Shape::n, Q = Shape::Q;
  static constexpr int sums = Plan::channels * Shape::controls;  ///< of a tile
  static constexpr int warps_apart = 32;                         ///< threads of the first ones of different warps

  TileTask<Plan> task;
  TileGrid<D> grid;
  Real* partial;  ///< [tile][channel][plane][cy][cx]

  static KOKKOS_FORCEINLINE_FUNCTION int least(int a, int b) { return a < b ? a : b; }
  static KOKKOS_FORCEINLINE_FUNCTION int within(int low, int i, int high) { return i < low ? low : least(i, high); }

  /// What control i along an axis but the first adds to its place. Outside of the region it repeats the nearest one.
  KOKKOS_FORCEINLINE_FUNCTION int place_along(int d, int i) const {
    const int at = least(i, grid.elements[d] + P - 1);
    return (d == D - 1 ? task.axis[d].first_functions[0] + at : at) * task.stride[d];
  }
  /// The integers of Room::places. Elements outside of the region have the control values of the nearest one.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_places(const Team& team, const int (&corner)[D], int* places) const {
    share_from(team, warps_apart, Shape::NX,
               [&](int e) { places[e] = grid.first[0] + within(grid.lead, corner[0] + e, grid.elements[0] - 1); });
    if constexpr (D == 3)
      share_from(team, 2 * warps_apart, Shape::cy,
                 [&](int j) { places[Room::y_places + j] = place_along(1, corner[1] + j); });
    share_from(team, 3 * warps_apart, Shape::NZ + P,
               [&](int k) { places[Room::z_places + k] = place_along(D - 1, corner[D - 1] + k); });
  }
  /// Passes of the tile with this corner.
  KOKKOS_FORCEINLINE_FUNCTION int passes(const int (&corner)[D]) const {
    return least(Shape::M, (grid.elements[D - 1] - corner[D - 1] + Shape::L - 1) / Shape::L);
  }

  /// Tables of an axis for the elements of a tile; those outside of the region have no weight. A place is null where a
  /// table is not wanted.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_axis(const Team& team, int first_thread, const AxisTables<Real>& rule, int d,
                                             int corner, int count, Real* basis, Real* weight, Real* place,
                                             Real* element) const {
    const int each = d == D - 1 ? Shape::QL : Q;
    share_from(team, first_thread, count * each, [&](int i) {
      const int e = corner + quotient(i, each), q = modulo(i, each), low = d == 0 ? grid.lead : 0;
      const int known = grid.first[d] + within(low, e, grid.elements[d] - 1);
      for (int a = 0; a < n; ++a) basis[i * n + a] = rule.value(q, a, known);
      if (!weight) return;
      weight[i] = e >= low && e < grid.elements[d] ? rule.weight(q, known) : Real(0);
      place[i] = rule.position(q, known);
      if (q == 0) element[quotient(i, each)] = rule.share(known);
    });
  }
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_tables(const Team& team, const int (&corner)[D], Real* t) const {
    load_axis(team, 0, task.axis[0], 0, corner[0], Shape::NX, t + Room::x, t + Room::x_weight, t + Room::x_place,
              t + Room::x_share);
    if constexpr (D == 3)
      load_axis(team, warps_apart, task.axis[1], 1, corner[1], Shape::NY, t + Room::y, t + Room::y_weight,
                t + Room::y_place, t + Room::y_share);
    constexpr int last = D - 1;
    load_axis(team, 2 * warps_apart, task.axis[last], last, corner[last], Shape::NZ, t + Room::z, t + Room::z_weight,
              t + Room::z_place, t + Room::z_share);
    load_axis(team, 3 * warps_apart, task.test, last, corner[last], Shape::NZ, t + Room::test, nullptr, nullptr,
              nullptr);
    if constexpr (Plan::on_wall) share(team, n, [&](int a) { t[Room::z_slope + a] = task.axis[last].slope(0, a, 0); });
  }

  /// The numbers of the Blend, when the tables are there.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void load_blend(const Team& team, Real* t) const {
    if constexpr (Room::knows_blend) {
      constexpr int first = 4 * warps_apart;
      const auto load = [&](int i) {
        t[Room::blend + i] = static_cast<Real>(task.motion.blend.value(t[Room::z_place + i]));
        if (i == 0) t[Room::blend_slope] = static_cast<Real>(task.motion.blend.slope());
      };
      if constexpr (Shape::own_slopes) {
        share_known<Room::zs, first>(team, load);
      } else {
        share_from(team, first, Room::zs, load);
      }
    }
  }

  /// Geometry at a point above point `at` of the wall, in layer z of the points of a tile.
  KOKKOS_FORCEINLINE_FUNCTION auto geometry(int at, int z, const Real* t, const Vector<S, D>& reference) const {
    const Real* const wall = t + Room::wall + at;
    if constexpr (Room::knows_blend) {
      const KnownBlend<Real> blend{t[Room::blend + z], t[Room::blend_slope]};
      return moving_point<N, Shape::base, Plan::on_wall>(blend, task.motion.scale, wall, reference, 0);
    } else {
      return point_above_wall<N, Shape::base, Plan::on_wall>(task.motion, wall, reference, t[Room::z_place + z]);
    }
  }

  /// Point p of a pass with what it remembers. @param corner  of the pass; elements outside of the region have the
  /// memory of the nearest one, and no weight
  template <class Point>
  KOKKOS_FORCEINLINE_FUNCTION auto with_memory_of(const Point& point, int p, const int (&corner)[D]) const {
    if constexpr (memory_size_of<typename Plan::Trial> == 0) {
      return point;
    } else {
      static_assert(Shape::QL == Q, "points of a volume remember");
      const auto number = PointNumbers<Shape>::of(p);
      const int at[3] = {number.x, D == 3 ? number.y : number.z, number.z};
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

  /// The term at point p of a pass, from the fields there. sink(p) takes its integrands.
  template <class Fields, class Sink>
  KOKKOS_FORCEINLINE_FUNCTION void evaluate(int p, int pass, const int (&corner)[D], const Real* t, const Fields& from,
                                            const Sink& sink) const {
    const auto number = PointNumbers<Shape>::of(p);
    const int z = pass * Shape::qz + number.z;
    Vector<S, D> reference;
    reference[0] = S(t[Room::x_place + number.x]);
    if constexpr (D == 3) reference[1] = S(t[Room::y_place + number.y]);
    reference[D - 1] = S(t[Room::z_place + z]);
    const auto place = in_coordinates<typename Plan::Term>(geometry(number.wall, z, t, reference), reference);
    const auto point = with_memory_of(place, p, corner);
    using Point = std::remove_const_t<decltype(point)>;
    using From = Reader<N, D, Fields, Point>;
    const auto test = task.term.residual(Plan::Trial::read(From{from, point, 0}));
    const int again = anew(p);  // the numbers derived from p were discarded
    const auto numbers = PointNumbers<Shape>::of(again);
    Real weight = task.factor * t[Room::x_weight + numbers.x] * t[Room::z_weight + pass * Shape::qz + numbers.z];
    if constexpr (D == 3) weight = weight * t[Room::y_weight + numbers.y];
    auto to = sink(again);
    TileWriter<Plan, Point, decltype(to)> writer{to, point, S(weight)};
    test.write(writer);
  }

  /// Field f of the wall's motion; null where it is zero.
  KOKKOS_FORCEINLINE_FUNCTION const Real* of_wall(int f, const Real* direction) const {
    if (f < D) return task.motion.displacement[f];
    if (f < 2 * D) return task.motion.velocity[f - D];
    return task.tangents.moves ? direction + task.tangents.of_wall[f - 2 * D] : nullptr;
  }

  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION Real* partial_of(const Team& team) const {
    return partial + std::int64_t(team.tile()) * sums;
  }
};

}  // namespace softwet
