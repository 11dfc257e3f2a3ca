// How far droplets and films are from each other and from the sides at the start (host).
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Two things with fluid between them.
struct Gap {
  std::string one, other;  ///< "droplet[0]" and "film[1]", or "the top"
  double width;            ///< scale L0; 0 or less: they overlap
};

/// The largest number of gaps that is looked for.
inline constexpr std::size_t most_gaps = 1000;

/// All gaps below a width, or `most_gaps` of them: between droplets, between a droplet and a film, and between these
/// and a side that they do not touch. The narrowest comes first. A cap on the wall touches the wall, half a droplet its
/// plane of symmetry, and a film the sides that its box reaches. Gaps between caps are those at the wall. Ellipses are
/// taken along the line between the centres.
/// Bodies are sorted along the first axis, so that the work grows like their number times those that lie above each
/// other.
/// Tested: tests/unit/scene/test_forecast.cpp
std::vector<Gap> narrow_gaps(const Case&, double width);

}  // namespace softwet
