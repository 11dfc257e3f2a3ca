// What becomes of the droplets of a run as wholes: which vanish, merge, reach a side, leave the wall. Plain numbers.
#pragma once

#include "observe/host/bodies.hpp"

namespace softwet {

/// Which points of a regular grid lie in a droplet (in a bubble where the ambient is liquid), first axis fastest. The
/// grid of a periodic axis has no point at its upper end.
struct PhaseSamples {
  int dimension = 2;                       ///< 2 or 3; the last axis is vertical
  std::array<int, 3> points{1, 1, 1};      ///< per axis
  std::array<bool, 3> periodic{};          ///< per axis
  std::array<double, 3> origin{}, step{};  ///< of the grid; the lower end of the vertical axis is the wall
  std::vector<bool> inside;
  bool bubbles = false;  ///< inside is vapour
};

/// Follows the bodies to a new state and returns a sentence for each thing that happened since the last one. A body is
/// the connected region that holds its place or, where it has moved on, the nearest one that no other body holds. What
/// holds in the first state, such as half a droplet on its plane of symmetry, is no event, unless a body is missing or
/// overlaps another; nothing is told twice.
std::vector<std::string> follow(std::vector<Body>& bodies, const PhaseSamples& samples,
                                const std::vector<std::string>& names);

}  // namespace softwet
