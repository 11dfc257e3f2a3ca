// The means of the functions of an axis over an element, for terms of means and for output of their results.
#pragma once

#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// Values of the functions that live on an element, and their slopes: at a point of it, or their means over it.
struct Living {
  std::vector<double> values, slopes;
};

/// What the means along an axis are weighted by. In (r, z) integrals have the weight r.
enum class MeanWeight { uniform, radius };

/// With the weight r the means of v and of dv_r/dr + v_r/r have that weight, where v_r/r is the mean of v_r over the
/// radius of the middle. So a stress that is the same along r and around the axis has no resultant along r within a
/// layer, and an upright one pulls at the functions of a wall as a pressure on the wall does. The means of dv_r/dr and
/// v_r/r alone are off near the axis, by h^2/(12 r^2) of themselves.
Living means_of(const Axis&, int element, MeanWeight weight);

}  // namespace softwet
