#include "casefile/formula/jumps.hpp"

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

constexpr double least_height = 1;  ///< of a jump that is reported
constexpr double width = 1e-3;      ///< of an element: what changes within it jumps
constexpr int most_lines = 64;      ///< of a wall in 3D, along each axis

/// The change of a profile between two positions on an axis that is left when the half of it that changes more is
/// halved again.
Jump steepest(const Profile& profile, std::array<double, 3> place, int axis, double low, double high) {
  const auto at = [&](double x) {
    place[axis] = x;
    return profile.at(place);
  };
  const double end = width * (high - low);
  double below = at(low), above = at(high);
  while (high - low > end) {
    const double middle = 0.5 * (low + high), between = at(middle);
    const bool left = std::abs(between - below) > std::abs(above - between);
    (left ? high : low) = middle;
    (left ? above : below) = between;
  }
  place[axis] = 0.5 * (low + high);
  return {place, above - below};
}

}  // namespace

std::optional<Jump> jump_along_wall(const Case& c, const Profile& profile) {
  if (!profile.varies()) return {};
  std::optional<Jump> largest;
  const int axes = c.dimension() - 1;
  const double wall = c.wall_height();
  for (int axis = 0; axis < axes; ++axis) {
    const int other = 1 - axis, elements = c.domain.elements[axis];
    const int lines = axes == 1 ? 1 : std::min(most_lines, c.domain.elements[other]);
    for (int line = 0; line < lines; ++line) {
      std::array<double, 3> place{0, 0, 0};
      if (axes == 2) place[other] = c.domain.size[other] * (line + 0.5) / lines;
      place[axes] = wall;
      for (int i = 0; i < elements; ++i) {
        const double h = c.domain.size[axis] / elements;
        const Jump jump = steepest(profile, place, axis, i * h, (i + 1) * h);
        if (std::abs(jump.height) < least_height) continue;
        if (!largest || std::abs(jump.height) > std::abs(largest->height)) largest = jump;
      }
    }
  }
  return largest;
}

}  // namespace softwet
