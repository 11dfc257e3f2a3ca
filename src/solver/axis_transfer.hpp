// One axis of the step between a spline space and that of half as many elements, as tables for kernels.
#pragma once

#include "field/array.hpp"
#include "spline/refinement.hpp"

namespace softwet {

/// Sums along an axis: result(i) = sum over k of weight(i, k) from(source(i, k)). All sums have the same number of terms;
/// those that are not needed have the weight zero.
struct AxisSums {
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> source;
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> weight;
};

struct AxisTransfer {
  AxisSums to_coarse, to_fine;  ///< transposes of each other; nothing is added to ghosts
  int fine = 0, coarse = 0;     ///< functions, ghosts included
};

AxisTransfer make_axis_transfer(const Axis& fine, const Refinement&);

}  // namespace softwet
