// The kernel of a device for terms with fewer than degree + 1 points along an axis, or of means over elements: slopes do not follow from
// values there, so that a tile sweeps them too. As in tile.hpp elements share all sums along the other axes.
#pragma once

#include "operator/device/slope_sweeps.hpp"
#include "operator/device/tile_point.hpp"

namespace softwet {

/// Fields at one point, as Reader wants them: the last sums, along the first axis, of what was swept along the others.
template <class Plan>
struct SlopeFields {
  using Shape = typename Plan::Shape;
  using Real = typename Plan::Real;
  using S = typename Plan::S;
  static constexpr int D = Shape::D, apart = SlopeRooms<Plan>::line_points;
  const PointBasis<Shape::n, Real>& basis;
  const Real* swept;  ///< [number][line][control], at the first control of the element
  const Real* scale;

  KOKKOS_FORCEINLINE_FUNCTION S part(int field, int c) const {
    const Real* from = swept + (field + (D - 1) * Plan::stored_before(field)) * apart;
    return S(c == 1 ? basis.sum(basis.slope, from, 1) : basis.sum(basis.value, from + (c > 1 ? c - 1 : 0) * apart, 1));
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

/// Takes the integrands of a point to the memory of the team, but for fluxes of channels that have none.
template <class Plan>
struct SlopeSink {
  using S = typename Plan::S;
  static constexpr int points = Plan::Shape::points, written = SlopeRooms<Plan>::written;
  typename Plan::Real* to;  ///< [channel][value, slopes][point], at this point

  KOKKOS_FORCEINLINE_FUNCTION void integrand(int channel, const S& number) {
    to[channel * written * points] = plain(number);
  }
  KOKKOS_FORCEINLINE_FUNCTION void flux(int channel, int d, const S& number) {
    if (channel_has_flux<typename Plan::Test>(channel)) to[(channel * written + 1 + d) * points] = plain(number);
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
  using Base::D, Base::Q, Base::task, Base::grid;

  void set_spacing(const double (&)[D]) {}

  KOKKOS_FORCEINLINE_FUNCTION void evaluate_at(int p, int pass, const int (&corner)[D], Real* t) const {
    const int x = p % Shape::qx;
    const PointBasis<Shape::n, Real> basis(t + Room::x, t + Room::x_slope, x);
    const SlopeFields<Plan> from{basis, t + Room::swept + p / Shape::qx * Shape::cx + x / Q, task.scale};
    this->evaluate(p, pass, corner, t, from, [&](int again) { return SlopeSink<Plan>{t + Room::integrands + again}; });
  }

  /// One pass: a layer of elements, added to the sums of the tile.
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run_pass(const Team& team, int pass, const Real* direction, Real* t) const {
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    corner[D - 1] += pass;
    Sweeps::along_z(
        team, pass, t, [&](int i, int j, int k) { return this->control(corner, i, j, k); },
        [&](int f) {
          if constexpr (Plan::Tangent)
            if (f >= Plan::slots) return direction + this->task.tangents.of_unknown[Plan::unknown_of(f)];
          return this->task.slot[f];
        });
    team.barrier();
    if constexpr (D == 3) {
      Sweeps::along_y(team, t);
      team.barrier();
    }
    share_points<Shape::points>(team, [&](int p, int) { evaluate_at(p, pass, corner, t); });
    team.barrier();
    Sweeps::fold_x(team, t);
    team.barrier();
    if constexpr (D == 3) {
      Sweeps::fold_y(team, t);
      team.barrier();
    }
    Sweeps::fold_z(team, pass, t, this->partial_of(team));
  }

  /// @param direction  of a product
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Real* direction, Real* t) const {
    int corner[D];
    grid.template corner<Shape>(team.tile(), corner);
    this->load_tables(team, corner, t);
    team.barrier();
    this->load_blend(team, t);
    if constexpr (Plan::moves)
      Sweeps::trace(
          team, t, [&](int i, int j) { return this->column(corner, i, j); },
          [&](int f) { return this->of_wall(f, direction); });
    const int passes = this->passes(corner);
    for (int pass = 0; pass < passes; ++pass) run_pass(team, pass, direction, t);
    team.barrier();
    Sweeps::store(team, passes, t, this->partial_of(team));
  }
};

}  // namespace softwet
