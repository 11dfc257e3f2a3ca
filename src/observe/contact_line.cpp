#include "observe/contact_line.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "observe/crossings.hpp"

namespace softwet {

namespace {

using Point = std::array<double, 2>;

/// Points on the surface of the left and right half of the droplet whose wall crossings are given (reference
/// coordinates).
struct Sides {
  std::vector<Point> left, right;
};
template <int D>
Sides trace_surface(const Section<D>& section, double left, double right, const Surface& surface, double start) {
  const Axis& vertical = section.snapshot().layout().axis[D - 1];
  const double low = section.snapshot().wall_height(), middle_x = 0.5 * (left + right);
  // Height of the droplet above its middle.
  const std::vector<double> column = equidistant(low, vertical.length(), 4 * vertical.equal_parts());
  const std::vector<double> along = surface.depth(section.density({middle_x}, column));
  double top = low;
  for (const Crossing& c : crossings(column, along.data()))
    if (c.direction < 0) {
      top = c.x;
      break;
    }
  Sides sides;
  if (top - low < 1.5 * start) return sides;
  const std::vector<double> x = section.abscissas(4);
  const std::vector<double> y = equidistant(low + start, low + start + 0.85 * (top - low - start), 24);
  const double beside = 0.5 * (right - left);
  const Window window = window_of(x, left - beside, right + beside);
  const std::vector<double> depth = surface.depth(section.density(window.x, y));
  for (std::size_t j = 0; j < y.size(); ++j) {
    const auto row = [&] { return surface.depth(section.density(x, {y[j]})); };
    const auto crossing = [&](int direction) {
      return nearest_crossing(window, depth.data() + j * window.x.size(), x, row, middle_x, direction);
    };
    if (const auto c = crossing(1)) sides.left.push_back(section.current(c->x, y[j]));
    if (const auto c = crossing(-1)) sides.right.push_back(section.current(c->x, y[j]));
  }
  return sides;
}

/// A droplet cut by a side of the domain, its plane of symmetry, begins or ends there.
std::vector<Crossing> with_cut_droplets(std::vector<Crossing> found, const Reach& reach,
                                        const std::vector<double>& trace) {
  if (reach.low_is_side && trace.front() >= 0) found.insert(found.begin(), {reach.low, 1});
  if (reach.high_is_side && trace.back() >= 0) found.push_back({reach.high, -1});
  return found;
}

/// Angle at which a circle meets a height, in the liquid, degrees.
std::optional<double> angle_at(const std::optional<Circle>& circle, double height, const Surface& surface) {
  if (!circle) return std::nullopt;
  const double cosine = (height - circle->y) / circle->radius;
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  return surface.angle_in_liquid(std::acos(cosine) * 180 / M_PI);
}

}  // namespace

std::optional<Circle> fit_circle(const std::vector<Point>& points) {
  if (points.size() < 5) return std::nullopt;
  Eigen::MatrixXd a(points.size(), 3);
  Eigen::VectorXd b(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    a.row(i) << x, y, 1;
    b[i] = -(x * x + y * y);
  }
  const Eigen::Vector3d c = a.colPivHouseholderQr().solve(b);
  const double x = -0.5 * c[0], y = -0.5 * c[1], square = x * x + y * y - c[2];
  if (!(square > 0)) return std::nullopt;
  return Circle{x, y, std::sqrt(square)};
}

template <int D>
std::vector<Footprint> find_footprints(const Section<D>& section, const Surface& surface, double capillarity) {
  const Reach& reach = section.reach();
  const std::vector<double> x = section.abscissas(4);
  const double low = section.snapshot().wall_height(), element = 4 * (x[1] - x[0]);
  const std::vector<double> trace = surface.depth(section.density(x, {low}));
  const std::vector<Crossing> found = with_cut_droplets(crossings(x, trace.data()), reach, trace);
  const auto sharp = [&](const Crossing& c) {
    return section.at_low_side(c.x) || section.at_high_side(c.x) ? c.x
                                                                 : sharpen_mean(section, c, low, element, surface);
  };
  std::vector<Footprint> result;
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    if (found[i].direction < 0 || found[i + 1].direction > 0) continue;
    const double left = sharp(found[i]), right = sharp(found[i + 1]);
    const Point line_left = section.current(left, low), line_right = section.current(right, low);
    Footprint f;
    f.x_left = line_left[0], f.x_right = line_right[0];
    f.cut_left = section.at_low_side(left), f.cut_right = section.at_high_side(right);
    // A cut droplet has its middle on the side: as wide beyond it as before.
    const double mirrored_left = f.cut_left ? 2 * reach.low - right : left,
                 mirrored_right = f.cut_right ? 2 * reach.high - left : right;
    const Sides sides = trace_surface(section, mirrored_left, mirrored_right, surface, 2 * capillarity);
    f.angle_left = angle_at(fit_circle(sides.left), line_left[1], surface);
    f.angle_right = angle_at(fit_circle(sides.right), line_right[1], surface);
    if (!f.cut_left) f.left = line_shape(section, surface, {left, 1}, right, capillarity);
    if (!f.cut_right) f.right = line_shape(section, surface, {right, -1}, left, capillarity);
    f.dimple = dimple(section, left, right);
    result.push_back(f);
  }
  return result;
}

template std::vector<Footprint> find_footprints(const Section<2>&, const Surface&, double);
template std::vector<Footprint> find_footprints(const Section<3>&, const Surface&, double);

}  // namespace softwet
