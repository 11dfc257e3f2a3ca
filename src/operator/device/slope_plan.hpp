// Where a team keeps the numbers of a tile with slopes of its own, and its bases.
#pragma once

#include "operator/device/tile_plan.hpp"

namespace softwet {

/// Where a team keeps its numbers; offsets in Reals. After z a field with slopes has its value and its slope along z, after y
/// the slope along y before the latter. Two rooms are used in turn. What is read last in a pass lies behind what the next one
/// writes first, so that no barrier is between them.
template <class Plan>
struct SlopeRooms {
  using Shape = typename Plan::Shape;
  static constexpr bool three = Shape::D == 3, has_flux = Plan::Test::has_flux;
  static constexpr int max(int a, int b) { return a > b ? a : b; }
  static constexpr int columns = Shape::cx * Shape::cy, layer = Shape::QL * columns;
  static constexpr int lines = Shape::QL * Shape::qy, line_points = lines * Shape::cx;  ///< along x
  static constexpr int written = has_flux ? 1 + Shape::D : 1;  ///< numbers of a channel at a point, and after folds
  static constexpr int folded = has_flux ? Shape::D : 1, folded_again = has_flux ? 2 : 1;

  static constexpr int sweep_z = (Plan::fields + Plan::stored) * layer;
  static constexpr int sweep_y = (Plan::fields + 2 * Plan::stored) * line_points;
  static constexpr int at_points = Plan::channels * written * Shape::points;
  static constexpr int fold_x = Plan::channels * folded * line_points, fold_y = Plan::channels * folded_again * layer;
  static constexpr int wall_y = three ? Plan::wall_fields * 2 * Shape::qy * Shape::cx : 0;

  static constexpr int last_fold = three ? fold_y : fold_x;
  static constexpr int first_room = max(sweep_z + last_fold, three ? max(at_points, wall_y) : 0);
  static constexpr int second_room = three ? max(sweep_y, fold_x) : at_points;
  static constexpr int swept_z = 0, swept = three ? first_room : 0;  ///< before the last sweep
  static constexpr int integrands = three ? 0 : first_room, folded_x = three ? first_room : sweep_z;
  static constexpr int folded_y = sweep_z;  ///< what the fold along z reads
  static constexpr int wall = first_room + second_room, tables = wall + Plan::wall_numbers * Shape::base;
};
template <class Plan>
struct SlopeScratch : SlopeRooms<Plan>, TileTables<Plan, SlopeRooms<Plan>::tables> {
  using TileTables<Plan, SlopeRooms<Plan>::tables>::three;
};

/// Values and slopes of the functions of an element at one point.
template <int n, class Real>
struct PointBasis {
  Real value[n], slope[n];

  PointBasis() = default;
  /// Of point i in the tables.
  KOKKOS_FORCEINLINE_FUNCTION PointBasis(const Real* values, const Real* slopes, int i) {
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) {
      value[a] = values[i * n + a];
      slope[a] = slopes[i * n + a];
    }
  }
  /// sum_a basis[a] from[a stride]
  static KOKKOS_FORCEINLINE_FUNCTION Real sum(const Real (&basis)[n], const Real* from, int stride) {
    Real total = basis[0] * from[0];
    SOFTWET_UNROLL
    for (int a = 1; a < n; ++a) total = total + basis[a] * from[a * stride];
    return total;
  }
};

}  // namespace softwet
