// The motion of the wall as a team of a device keeps it, and the geometry above it.
#pragma once

#include "operator/motion.hpp"

namespace softwet {

/// Calls body with 0, 1, ..., count - 1 as types.
template <int count, class Body>
KOKKOS_FORCEINLINE_FUNCTION void for_each_index(const Body& body) {
  [&]<int... i>(std::integer_sequence<int, i...>) { (body(std::integral_constant<int, i>()), ...); }
  (std::make_integer_sequence<int, count>());
}

/// Numbers for each point of the wall: displacement [i][value, slopes], velocity [i], and for a product tangent
/// [i][value, slopes].
template <int D, class Motion, bool Tangent>
struct WallFields {
  static constexpr bool moves = !std::is_same_v<Motion, NoMotion>;
  static constexpr int wall_fields = moves ? (Tangent ? 3 : 2) * D : 0;
  static constexpr int wall_numbers = moves ? D * D + D + (Tangent ? D * D : 0) : 0;
  static constexpr bool wall_slopes(int field) { return field / D != 1; }
  static constexpr int wall_place(int field) {
    return field < D ? field * D : field < 2 * D ? D * D + field - D : D * D + D + (field - 2 * D) * D;
  }
};

/// The fields of the wall below a point, in the form of point_or_face; `apart` is the distance between the numbers of a
/// point.
template <class S, int D, int apart, class Real>
struct WallBelow {
  const Real* at;

  KOKKOS_FORCEINLINE_FUNCTION S displacement(int i, int c) const { return S(at[(i * D + c) * apart]); }
  KOKKOS_FORCEINLINE_FUNCTION S velocity(int i) const { return S(at[(D * D + i) * apart]); }
  KOKKOS_FORCEINLINE_FUNCTION S tangent(int i, int c) const { return S(at[(D * D + D + i * D + c) * apart]); }
};

/// A Blend at one height, from numbers that a team keeps.
template <class Real>
struct KnownBlend {
  Real at, slope_;
  KOKKOS_FORCEINLINE_FUNCTION Real value(double) const { return at; }
  KOKKOS_FORCEINLINE_FUNCTION Real slope() const { return slope_; }
};

/// Geometry at a point above a wall that moves; `wall` is the first number of the point of the wall below it.
template <class N, int apart, bool face, class AsBlend, class Real, class S, int D>
KOKKOS_FORCEINLINE_FUNCTION auto moving_point(const AsBlend& blend, Real scale, const Real* wall,
                                              const Vector<S, D>& reference, double height) {
  return point_or_face<N, face>(blend, scale, reference, height, WallBelow<S, D, apart, Real>{wall});
}
/// Geometry at a point above a wall that moves, or at a point of a fixed mesh.
template <class N, int apart, bool face, class Motion, class Real, class S, int D>
KOKKOS_FORCEINLINE_FUNCTION auto point_above_wall(const Motion& motion, const Real* wall, const Vector<S, D>& reference,
                                                  double height) {
  if constexpr (std::is_same_v<Motion, NoMotion>) {
    return fixed_point<N>(reference);
  } else {
    return moving_point<N, apart, face>(motion.blend, motion.scale, wall, reference, height);
  }
}

}  // namespace softwet
