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

/// With the weight r slopes have means with it, and values plain ones: over the radius of the middle these are the
/// means of v_r / r with the weight r. A uniform stress that is the same along r and around the axis then has no
/// resultant within a layer.
Living means_of(const Axis&, int element, MeanWeight weight);

}  // namespace softwet
