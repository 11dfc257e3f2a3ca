// Which side of the joint of a solid a position at it belongs to.
#pragma once

#include <algorithm>

#include "spline/axis.hpp"

namespace softwet {

/// Heights that differ by less than this share of the length of the axis are one height.
inline constexpr double one_height = 1e-9;

/// A height in the solid below its joint (part 0) or above it (part 1). At the joint it is moved by a hair into that
/// part, so that what jumps there, such as the stiffness, is the limit from this side. Without a joint there is one
/// part.
inline double height_in_part(const Axis& vertical, int part, double height) {
  if (vertical.joint() == 0) return height;
  const double joint = vertical.lower(vertical.joint()), beside = one_height * vertical.length();
  return part == 0 ? std::min(height, joint - beside) : std::max(height, joint + beside);
}

}  // namespace softwet
