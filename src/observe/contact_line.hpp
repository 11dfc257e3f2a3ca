// Contact lines and apparent angles of droplets or bubbles on the wall, in a vertical plane.
#pragma once

#include <optional>

#include "observe/line_shape.hpp"

namespace softwet {

/// The footprint of a droplet, bubble or film in a section (2D: the domain, x = s), in current coordinates.
struct Footprint {
  double x_left = 0, x_right = 0;  ///< where the mean of rho is (rho_l + rho_v)/2 on the wall, or the side that cuts it
  std::optional<double> angle_left, angle_right;  ///< apparent angles, degrees, in the liquid
  LineShape left, right;
  std::optional<double> dimple = {};         ///< smallest rise of the wall between the ends
  bool cut_left = false, cut_right = false;  ///< by a side of the domain: nothing lies beyond
  double centre() const { return 0.5 * (x_left + x_right); }
  bool holds(double x) const { return (cut_left || x_left <= x) && (cut_right || x <= x_right); }
};

/// A circle fitted to points (algebraic least squares, Kasa 1976).
struct Circle {
  double x, y, radius;
};
std::optional<Circle> fit_circle(const std::vector<std::array<double, 2>>& points);

/// Footprints of the phase that is inside, from left to right. A droplet that reaches a side of the domain ends there,
/// without an angle. To find the apparent angle of a side, a circle is fitted to the level set of its half of the
/// droplet, from 2 g above the wall; its angle is taken where it meets the height of that side's contact line. Where
/// the fit begins (g .. 3 g) and ends moves the angle by 0.05 degrees. The height matters: a contact line on a ridge of
/// 5e-3 reads 2 degrees less than the same circle at the undeformed wall (docs/verification/tensotaxis.md).
/// @param capillarity  g, sets where the fit begins
template <int D>
std::vector<Footprint> find_footprints(const Section<D>&, const Surface&, double capillarity);

}  // namespace softwet
