// Tables of one axis of a region: basis values and slopes at the quadrature points of each element, in device memory.
#pragma once

#include <vector>

#include "memory/array.hpp"
#include "spline/axis.hpp"
#include "spline/columns.hpp"
#include "spline/means.hpp"

namespace softwet {

inline constexpr int lane_padding = 16;  ///< tables carry this many copies of the last element behind it

/// value, slope: [point][function][element]; weight: [point][element]; share, first: [element], first living function.
template <class Real>
struct AxisRuleOf {
  Kokkos::View<const Real***, Kokkos::LayoutRight, Exec> value, slope;
  Kokkos::View<const Real**, Kokkos::LayoutRight, Exec> weight;
  Kokkos::View<const Real**, Kokkos::LayoutRight, Exec> position;
  Kokkos::View<const Real*, Exec> share;  ///< spacing over the length of each element
  Kokkos::View<const int*, Exec> first;
  int elements = 0;
  int points = 0;
  double spacing = 0;  ///< length of the shortest element
};
using AxisRule = AxisRuleOf<double>;

/// The rule with tables rounded to single precision.
AxisRuleOf<float> in_single(const AxisRule&);

/// Gauss points on the elements [first, last).
AxisRule gauss_rule(const Axis&, int first, int last, int points);

/// Gauss rule on the elements that a process stores.
AxisRule gauss_rule(const Axis&, const ElementColumns&, int points);

/// The means of the functions and of their slopes over each element, `points` times with a share of its length: kernels
/// for so many points then see one point with these means.
AxisRule mean_rule(const Axis&, int first, int last, int points, MeanWeight = MeanWeight::uniform);
AxisRule mean_rule(const Axis&, const ElementColumns&, int points, MeanWeight = MeanWeight::uniform);

/// One point of weight 1 at the lower end of element `first`: the trace on a face.
AxisRule low_face_rule(const Axis&, int first);

/// The point at the upper end of element `last`.
AxisRule high_face_rule(const Axis&, int last);

/// The points of `rule` with every function but `function` (local index) set to zero: restricts a test space.
AxisRule restricted_to(const AxisRule& rule, int function);

/// The points of `rule` with one test function for all elements, 1 - (x - low) / height, at control value `row`.
AxisRule linear_from(const AxisRule& rule, int row, double low, double height);

}  // namespace softwet
