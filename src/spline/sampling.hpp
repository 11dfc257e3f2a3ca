// Control values of functions of the place: where along an axis they are taken from.
#pragma once

#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// A control value is the sum of weight times the function's value at place. The weights are positive and add up to 1,
/// so that a control value cannot leave the range of the function. Round a periodic axis a place may lie outside of the
/// domain.
struct Samples {
  std::vector<double> place, weight;
};

/// The samples of each function of an axis. Where the elements under a function are equal, its Greville point alone.
/// Elsewhere, Gauss points with the weights N_i / int N_i, so that the spline keeps the integral of the sampled
/// function, with the weight of the axis in both integrals.
std::vector<Samples> samples_of(const Axis&);

}  // namespace softwet
