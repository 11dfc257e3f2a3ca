#include "observe/line_shape.hpp"

#include <algorithm>
#include <cmath>

#include "observe/crossings.hpp"
#include "observe/host/places.hpp"

namespace softwet {
namespace {

constexpr double degree = 180 / M_PI;

/// The largest rise of the wall between two places, with a sample for each eighth of a distance or more.
template <int D>
double largest_rise(const Section<D>& section, double low, double high, double distance, double sign) {
  const int parts = std::clamp(parts_no_longer(high - low, distance / 8), 2, 400);
  std::vector<double> rise = section.rise(equidistant(low, high, parts));
  for (double& value : rise) value *= sign;
  return sign * top_of(rise);
}

/// The place of the undeformed wall that is now so far from a contact line along the plane; empty: it is not inside.
template <int D>
std::optional<double> place_beside(const Section<D>& section, double line, double distance) {
  const double wall = section.snapshot().wall_height(), target = section.current(line, wall)[0] + distance;
  double s = line + distance;
  for (int i = 0; i < 50; ++i) {
    if (s < section.reach().low || s > section.reach().high) return std::nullopt;
    const double miss = section.current(s, wall)[0] - target;
    s -= miss;
    if (std::abs(miss) < 1e-10 * std::abs(distance)) return s;
  }
  return std::nullopt;
}

/// What covers a place of the wall: a droplet (in liquid a bubble), or its surroundings.
enum class Below { droplet, surroundings };

/// Angle of the wall next to a line, on the side of positive or negative distances; empty where something else covers
/// the wall there.
template <int D>
std::optional<double> wall_angle(const Section<D>& section, const Surface& surface, double line, double distance,
                                 Below below) {
  const std::optional<double> s = place_beside(section, line, distance);
  if (!s) return std::nullopt;
  const double depth = surface.depth(section.density({*s}, {section.snapshot().wall_height()})[0]);
  if ((depth >= 0) != (below == Below::droplet)) return std::nullopt;
  const auto [along, up] = section.tangent(*s);
  return degree * std::atan2(distance > 0 ? -up : up, along);
}

/// Where the outline on the side of a contact line is now, at a height of the undeformed domain. It is looked for first
/// between a middle of the droplet and a place as far beyond the line.
template <int D>
std::optional<std::array<double, 2>> outline(const Section<D>& section, const Surface& surface, double middle,
                                             const Crossing& line, double height) {
  const std::vector<double> x = section.abscissas(4);
  const double beyond = 2 * line.x - middle;
  const Window window = window_of(x, std::min(middle, beyond), std::max(middle, beyond));
  const auto sample = [&](const std::vector<double>& at) { return surface.depth(section.density(at, {height})); };
  const std::vector<double> depth = sample(window.x);
  const auto row = [&] { return sample(x); };
  const auto crossing = nearest_crossing(window, depth.data(), x, row, middle, line.direction);
  if (!crossing) return std::nullopt;
  return section.current(sharpen(section, *crossing, height, x[1] - x[0], surface), height);
}

/// The outline's angle at a distance above a contact line.
template <int D>
std::optional<double> liquid_angle(const Section<D>& section, const Surface& surface, const Crossing& line,
                                   double other, double distance) {
  const double wall = section.snapshot().wall_height(), top = section.snapshot().layout().axis[D - 1].length();
  const bool cut = section.at_low_side(other) || section.at_high_side(other);
  const double middle = cut ? other : 0.5 * (line.x + other), shift = cut ? line.direction * 1e-9 * (top - wall) : 0;
  const auto at = [&](double height) {
    return height < top ? outline(section, surface, middle + shift, line, height) : std::nullopt;
  };
  const auto near = at(wall + distance);
  if (!near) return std::nullopt;
  // This height above the contact line is the requested one in the deformed domain, not in the undeformed one.
  const double height = wall + 2 * distance - ((*near)[1] - section.current(line.x, wall)[1]);
  const auto low = at(height - 0.1 * distance), high = at(height + 0.1 * distance);
  if (!low || !high) return std::nullopt;
  const double inside = degree * std::atan2((*high)[1] - (*low)[1], line.direction * ((*high)[0] - (*low)[0]));
  return surface.angle_in_liquid(inside);
}

}  // namespace

template <int D>
LineShape line_shape(const Section<D>& section, const Surface& surface, const Crossing& line, double other,
                     double capillarity) {
  const double distance = local_distance * capillarity;
  LineShape shape;
  shape.liquid = liquid_angle(section, surface, line, other, distance);
  if (!section.snapshot().layout().has_solid) return shape;
  const Reach& reach = section.reach();
  shape.ridge = largest_rise(section, std::max(reach.low, line.x - distance), std::min(reach.high, line.x + distance),
                             0.5 * capillarity, 1);
  const double inwards = line.direction * distance;
  const auto inside = wall_angle(section, surface, line.x, inwards, Below::droplet),
             outside = wall_angle(section, surface, line.x, -inwards, Below::surroundings);
  const bool liquid_inside = surface.inside == Phase::liquid;
  shape.wall_wet = liquid_inside ? inside : outside;
  shape.wall_dry = liquid_inside ? outside : inside;
  return shape;
}

template <int D>
std::optional<double> dimple(const Section<D>& section, double left, double right) {
  if (!section.snapshot().layout().has_solid || !(right > left)) return std::nullopt;
  return largest_rise(section, left, right, (right - left) / 16, -1);
}

template LineShape line_shape(const Section<2>&, const Surface&, const Crossing&, double, double);
template LineShape line_shape(const Section<3>&, const Surface&, const Crossing&, double, double);
template std::optional<double> dimple(const Section<2>&, double, double);
template std::optional<double> dimple(const Section<3>&, double, double);

}  // namespace softwet
