// The shape of wall and liquid near a contact line, in a vertical plane.
#pragma once

#include <optional>

#include "observe/section.hpp"

namespace softwet {

struct Crossing;  // observe/crossings.hpp

/// Capillarities from the contact point at which local angles are read, and within which the ridge is looked for.
constexpr double local_distance = 4;

/// Lengths in L0, angles in degrees. Empty where there is no solid, or where the place lies beyond the droplet or the
/// domain.
struct LineShape {
  std::optional<double> ridge;               ///< largest rise of the wall near the line
  std::optional<double> wall_wet, wall_dry;  ///< of the wall to the horizontal, positive where it rises to the line
  std::optional<double> liquid;              ///< of the outline to the horizontal, in the liquid
};

/// @param line         the contact point on the undeformed wall
/// @param other        where the footprint ends on its other side
/// @param capillarity  g, scale of the distances
template <int D>
LineShape line_shape(const Section<D>&, const Surface&, const Crossing& line, double other, double capillarity);

/// Smallest rise of the wall between two places.
template <int D>
std::optional<double> dimple(const Section<D>&, double left, double right);

}  // namespace softwet
