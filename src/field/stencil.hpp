// A matrix between control points that lie at most `degree` apart along every axis: how its values are stored.
#pragma once

#include <cstdint>

#include "field/layout.hpp"

namespace softwet {

/// Entries of a matrix, in single precision: such a matrix only serves preconditioners.
using StencilValues = Kokkos::View<float*, Exec>;

/// Control points along an axis of the boxes of `schwarz` (solver/schwarz/schwarz.hpp). On each side a process stores
/// one column less in addition to its own columns.
constexpr int box_width(int dimension) { return dimension == 2 ? 8 : 4; }

/// Index i on an axis of `extent` places, wrapped where the axis has a period (0: none); -1 outside.
KOKKOS_FORCEINLINE_FUNCTION int wrapped(int i, int extent, int period) {
  if (period > 0) {
    while (i < 0) i += period;
    i %= period;
  }
  return i >= 0 && i < extent ? i : -1;
}

/// values[(pair(a, u) offsets + o) points + i]: row of component a at control point i, column of component u at point
/// i + shift(o). C components (velocity, density, potential) on all points of the patch; what does not exist is zero.
/// Components that never couple have no values. Periodic axes wrap.
template <int D>
struct Stencil {
  int extent[D], period[D];  ///< control points along each axis, ghosts included; as in Layout
  int degree, components, points = 1, offsets = 1;

  explicit Stencil(const Layout<D>& layout) : degree(layout.axis[0].degree()), components(layout.components()) {
    for (int d = 0; d < D; ++d) {
      extent[d] = layout.extent(d);
      period[d] = layout.period(d);
      points *= extent[d];
      offsets *= 2 * degree + 1;
    }
  }
  /// Whether values are stored for a pair of components. While the mesh does not move, the equation of the chemical
  /// potential does not know the velocity.
  static KOKKOS_FORCEINLINE_FUNCTION bool couples(int row, int column) { return row <= D || column >= D; }
  /// Number of a pair that couples, from 0 on.
  KOKKOS_FORCEINLINE_FUNCTION int pair(int row, int column) const {
    return row * components + column - (row > D ? D : 0);
  }
  int pairs() const { return pair(components - 1, components - 1) + 1; }
  std::int64_t size() const { return std::int64_t(pairs()) * offsets * points; }
  /// Place of a value of a pair that couples.
  KOKKOS_FORCEINLINE_FUNCTION std::int64_t index(int row, int column, int offset, int point) const {
    return (std::int64_t(pair(row, column)) * offsets + offset) * points + point;
  }
  /// Distance along axis d from row to column.
  KOKKOS_FORCEINLINE_FUNCTION int shift(int offset, int d) const {
    for (int e = 0; e < d; ++e) offset /= 2 * degree + 1;
    return offset % (2 * degree + 1) - degree;
  }
  /// Coordinate i + shift along axis d, wrapped; -1 outside.
  KOKKOS_FORCEINLINE_FUNCTION int moved(int i, int shift, int d) const {
    return wrapped(i + shift, extent[d], period[d]);
  }
  KOKKOS_FORCEINLINE_FUNCTION int coordinate(int point, int d) const {
    for (int e = 0; e < d; ++e) point /= extent[e];
    return point % extent[d];
  }
  /// Control point at an offset from another; -1 outside.
  KOKKOS_FORCEINLINE_FUNCTION int neighbour(int point, int offset) const {
    int result = 0, stride = 1;
    for (int d = 0; d < D; ++d) {
      const int i = moved(point % extent[d], offset % (2 * degree + 1) - degree, d);
      if (i < 0) return -1;
      result += stride * i;
      stride *= extent[d];
      point /= extent[d];
      offset /= 2 * degree + 1;
    }
    return result;
  }
};

/// component_shift and component_first of a layout, for kernels.
template <int D>
struct ComponentPlaces {
  int shift[D + 2], first[D + 2];

  explicit ComponentPlaces(const Layout<D>& layout) {
    for (int c = 0; c < D + 2; ++c) {
      shift[c] = layout.component_shift(c);
      first[c] = layout.component_first(c);
    }
  }
};

}  // namespace softwet
