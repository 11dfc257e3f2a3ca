// What becomes of the droplets of a run as wholes: which vanish, merge, reach a side, leave the wall, and how far they
// move. Plain numbers.
#pragma once

#include <optional>

#include "observe/host/bodies.hpp"

namespace softwet {

/// How deep the points of a regular grid lie in a droplet (in a bubble where the ambient is liquid), first axis
/// fastest. The grid of a periodic axis has no point at its upper end.
struct PhaseSamples {
  int dimension = 2;                       ///< 2 or 3; the last axis is vertical
  std::array<int, 3> points{1, 1, 1};      ///< per axis
  std::array<bool, 3> periodic{};          ///< per axis
  std::array<double, 3> origin{}, step{};  ///< of the grid; the lower end of the vertical axis is the wall
  std::array<double, 3> low{-1e300, -1e300, -1e300},
      high{1e300, 1e300, 1e300};  ///< where elements are fine, less a margin; periodic: also beyond the ends
  std::vector<double> depth;      ///< any measure that is 0 on the surface and grows inwards
  bool bubbles = false;           ///< inside is vapour
  std::vector<double> rings;      ///< what points count, by place along a first axis that is a radius; empty: all alike

  bool inside(std::size_t point) const { return depth[point] >= 0; }
};

/// Follows the bodies to a new state and returns a sentence for each thing that happened since the last one. A body is
/// the connected region that holds its place or, where it has moved on, the nearest one that no other body holds. What
/// holds in the first state, such as half a droplet on its plane of symmetry, is not an event, unless a body is missing
/// or overlaps another; nothing is reported twice.
std::vector<std::string> follow(std::vector<Body>& bodies, const PhaseSamples& samples,
                                const std::vector<std::string>& names);

/// The centres of bodies that `follow` has seen in these samples: means of the places inside, weighted by their depth.
/// Along a periodic axis the mean is one of angles, and 0 where a body reaches all round. A body about an axis of
/// symmetry has its centre on it. Empty for a body that is gone.
using Centre = std::optional<std::array<double, 3>>;
std::vector<Centre> centres_of(const std::vector<Body>& bodies, const PhaseSamples& samples);

/// How far each body has moved, the shorter way around periodic axes of these samples; empty where it is gone.
std::vector<std::optional<double>> distances(const std::vector<Centre>& from, const std::vector<Centre>& to,
                                             const PhaseSamples& samples);

}  // namespace softwet
