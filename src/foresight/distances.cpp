#include "foresight/distances.hpp"

#include <algorithm>
#include <cmath>

#include "case/cap.hpp"

namespace softwet {
namespace {

/// A droplet as a circle or ellipse about its centre, or a film as a box.
struct Outline {
  std::string name;
  std::vector<double> lower, upper;       ///< of all that is in the fluid
  std::vector<double> centre, semi_axis;  ///< of a droplet; of a cap, centre and semi-axes of its footprint
  bool cap = false;
};

Outline outline_of(const Case& c, const Droplet& droplet, std::size_t k) {
  Outline o{"droplet[" + std::to_string(k) + "]", {}, {}, droplet.centre, {}, sits_on_wall(c, droplet)};
  const double cosine = o.cap ? cap_cosine(c, droplet) : -1;
  const std::size_t last = droplet.centre.size() - 1;
  for (std::size_t d = 0; d <= last; ++d) {
    double semi = droplet.radius * (droplet.stretch.empty() ? 1 : droplet.stretch[d]), low = semi, high = semi;
    if (o.cap && d == last) low = 0, high = semi * (1 - cosine);
    if (o.cap && d != last && cosine > 0) low = high = semi *= std::sqrt(1 - cosine * cosine);
    o.semi_axis.push_back(semi);
    o.lower.push_back(droplet.centre[d] - low);
    o.upper.push_back(droplet.centre[d] + high);
  }
  return o;
}

std::vector<Outline> outlines(const Case& c) {
  std::vector<Outline> all;
  for (std::size_t k = 0; k < c.droplets.size(); ++k) all.push_back(outline_of(c, c.droplets[k], k));
  const bool bubbles = c.fluid->ambient == Phase::liquid;  // films are of the liquid around them
  for (std::size_t k = 0; k < c.films.size() && !bubbles; ++k)
    all.push_back({"film[" + std::to_string(k) + "]", c.films[k].lower, c.films[k].upper, {}, {}});
  return all;
}

/// The distance between two positions, the shorter one around a periodic axis.
double away(const Case& c, std::size_t axis, double from, double to) {
  return c.boundary.side[axis][0] == Side::periodic ? std::remainder(to - from, c.domain.size[axis]) : to - from;
}

double between_droplets(const Case& c, const Outline& a, const Outline& b) {
  const std::size_t axes = a.centre.size() - (a.cap && b.cap ? 1 : 0);
  double square = 0, of_a = 0, of_b = 0;
  for (std::size_t d = 0; d < axes; ++d) {
    const double step = away(c, d, a.centre[d], b.centre[d]);
    square += step * step;
    of_a += std::pow(step / a.semi_axis[d], 2);
    of_b += std::pow(step / b.semi_axis[d], 2);
  }
  // An ellipse reaches 1/sqrt(sum (e_d/s_d)^2) from its centre along a unit vector e.
  return square == 0 ? -1 : std::sqrt(square) * (1 - 1 / std::sqrt(of_a) - 1 / std::sqrt(of_b));
}

/// Between boxes: of a film, or around a droplet.
double between_boxes(const Case& c, const Outline& a, const Outline& b) {
  double square = 0, overlap = -1e300;
  for (std::size_t d = 0; d < a.lower.size(); ++d) {
    const double middles = away(c, d, 0.5 * (a.lower[d] + a.upper[d]), 0.5 * (b.lower[d] + b.upper[d]));
    const double gap = std::abs(middles) - 0.5 * (a.upper[d] - a.lower[d] + b.upper[d] - b.lower[d]);
    square += std::pow(std::max(gap, 0.0), 2);
    overlap = std::max(overlap, gap);
  }
  return square > 0 ? std::sqrt(square) : overlap;
}

double between(const Case& c, const Outline& a, const Outline& b) {
  return a.centre.empty() || b.centre.empty() ? between_boxes(c, a, b) : between_droplets(c, a, b);
}

std::string side_of(std::size_t axis, int end, std::size_t axes) {
  if (axis + 1 == axes) return end == 0 ? "the wall" : "the top";
  const char* const names[2][2] = {{"left", "right"}, {"front", "back"}};
  return std::string("the ") + names[axis][end] + " side";
}

void add_sides(const Case& c, const Outline& o, double width, std::vector<Gap>& gaps) {
  const std::size_t axes = c.domain.size.size();
  for (std::size_t d = 0; d < axes; ++d) {
    if (c.boundary.side[d][0] == Side::periodic) continue;
    const double low = d + 1 == axes ? c.wall_height() : 0, high = c.domain.size[d], slack = 1e-9 * high;
    const double centre = o.centre.empty() ? 0.5 * (low + high) : o.centre[d];
    const double gap[2] = {o.lower[d] - low, high - o.upper[d]}, inside[2] = {centre - low, high - centre};
    for (int end : {0, 1}) {
      const bool touches = o.centre.empty() ? gap[end] <= slack : inside[end] <= slack;
      if (!touches && gap[end] < width) gaps.push_back({o.name, side_of(d, end, axes), gap[end]});
    }
  }
}

}  // namespace

std::vector<Gap> narrow_gaps(const Case& c, double width) {
  std::vector<Outline> all = outlines(c);
  std::vector<Gap> gaps;
  for (const Outline& o : all) add_sides(c, o, width, gaps);
  std::stable_sort(all.begin(), all.end(), [](const Outline& a, const Outline& b) { return a.lower[0] < b.lower[0]; });
  const bool periodic = c.boundary.side[0][0] == Side::periodic;
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t step = 1; step < n; ++step) {
      const std::size_t j = (i + step) % n;
      const bool round = j < i;  // beyond the upper end
      if (round && !periodic) break;
      if (all[j].lower[0] + (round ? c.domain.size[0] : 0) > all[i].upper[0] + width) break;
      if (round && all[i].lower[0] <= all[j].upper[0] + width) continue;  // found the other way
      const double gap = between(c, all[i], all[j]);
      if (gap < width) gaps.push_back({all[i].name, all[j].name, gap});
      if (gaps.size() >= most_gaps) return gaps;
    }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.width < b.width; });
  return gaps;
}

}  // namespace softwet
