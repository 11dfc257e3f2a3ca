// The surface of droplets, or of bubbles: a level of the density, and the phase that is inside.
#pragma once

#include <vector>

#include "case/case.hpp"

namespace softwet {

struct Surface {
  double level = 0;              ///< (rho_l + rho_v)/2, scale b
  Phase inside = Phase::liquid;  ///< vapour: bubbles

  /// Depth of a density: positive inside, 0 on the surface, negative outside.
  double depth(double density) const { return inside == Phase::liquid ? density - level : level - density; }
  /// Depths of many densities, in place.
  std::vector<double> depth(std::vector<double> densities) const {
    for (double& value : densities) value = depth(value);
    return densities;
  }
  /// An angle in the liquid, degrees, from the one inside.
  double angle_in_liquid(double angle_inside) const {
    return inside == Phase::liquid ? angle_inside : 180 - angle_inside;
  }
};

}  // namespace softwet
