// One axis of the step between a spline space and the space with half as many elements, as tables for kernels.
#pragma once

#include "memory/array.hpp"
#include "spline/columns.hpp"
#include "spline/refinement.hpp"

namespace softwet {

/// Sums along an axis: result(i) = sum over k of weight(i, k) from(source(i, k)). All sums have the same number of
/// terms; those that are not needed have the weight zero.
struct AxisSums {
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> source;
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> weight;
};

/// Which functions of an axis are stored where: all functions, or the functions of a process's columns.
struct AxisPlaces {
  std::vector<int> place;     ///< [function] -1: nowhere
  std::vector<int> function;  ///< [place] -1: a ghost of the whole axis
  std::vector<bool> own;      ///< [place] neither a ghost nor a copy
};
AxisPlaces axis_places(const Axis&, const Columns&);

struct AxisTransfer {
  AxisSums to_coarse;        ///< for own places
  AxisSums to_fine;          ///< its transpose; also for copies where what they need is stored
  int fine = 0, coarse = 0;  ///< places, ghosts included
};

AxisTransfer make_axis_transfer(const Axis& fine, const Refinement&, const AxisPlaces& fine_places,
                                const AxisPlaces& coarse_places);

}  // namespace softwet
