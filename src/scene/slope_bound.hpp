// A bound on the slopes of the motion of a mesh, from control values alone.
#pragma once

#include <array>

#include "field/stage.hpp"
#include "scene/regions.hpp"

namespace softwet {

/// The largest slopes of a displacement, squared: along each axis in the solid, along the wall, and the displacement of
/// the wall itself. A value that is not finite counts as infinity.
template <int D>
struct LargestSlopes {
  using value_type = double[];
  static constexpr int along_wall = D, at_wall = 2 * D - 1, count = 2 * D;
  unsigned value_count = count;
  const double* displacement;
  ConstArray per_step[D];  ///< a slope over the difference of neighbouring control values, by the lower one
  int extent[D];
  int nodes, wall;    ///< of a component; the first control point of the wall
  bool axisymmetric;  ///< along the first axis, whose first functions are the axis of symmetry
  ConstArray on_axis;

  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k < count; ++k) best[k] = 0;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < count; ++k) take(best[k], other[k]);
  }
  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    int stride = 1, rest = i;
    for (int d = 0; d < D; ++d) {
      const int place = rest % extent[d];
      if (place + 1 < extent[d]) {
        double square = 0;
        for (int c = 0; c < D; ++c) {
          const double* u = displacement + c * nodes + i;
          const double slope = (u[stride] - u[0]) * per_step[d](place);
          square += slope * slope;
        }
        take(best[d], square);
        if (i >= wall && d < D - 1) take(best[along_wall + d], square);
      }
      rest /= extent[d];
      stride *= extent[d];
    }
    double size = 0;
    for (int c = 0; c < D; ++c) size += displacement[c * nodes + i] * displacement[c * nodes + i];
    if (i >= wall) take(best[at_wall], size);
    if (axisymmetric && on_axis(i % extent[0]) != 0 && displacement[i] != 0)
      best[0] = Kokkos::Experimental::infinity_v<double>;
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION static void take(double& best, double value) {
    if (value > best) best = value;
    if (!(value <= best)) best = Kokkos::Experimental::infinity_v<double>;  // not a number
  }
};

/// Slopes of splines are means of the slopes between neighbouring control values, with weights that are positive and
/// have the sum 1. So the slope along an axis is at most the largest of these, and |Grad u|^2 is at most the sum of
/// their squares over the axes. Where it is below 1, det(I + Grad u) > 0: it is not zero for any part of the motion. The
/// motion of the fluid mesh has the slopes of the wall, at most, and along the last axis the motion of the wall over the
/// height of the fluid. In (r, z) u_r / r is a mean of du_r / dr, since the axis stays where it is.
/// Source: convex hulls of B-splines.   Tested: tests/unit/scene/test_fault_search.cpp
template <int D, int P>
class SlopeBound {
 public:
  explicit SlopeBound(const Regions<D>&);

  static constexpr int numbers = LargestSlopes<D>::count;
  /// Starts the kernel that finds the numbers.
  void ask(const Stage&, const Array& numbers) const;
  /// Whether they show that nothing is folded or inverted, anywhere on all processes. If not, there may be such a place.
  bool excludes_faults(const double* numbers) const;

 private:
  const Regions<D>& regions_;
  std::array<ConstArray, D> per_step_;
  ConstArray on_axis_;
};

}  // namespace softwet
