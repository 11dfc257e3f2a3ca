// Where the surface of droplets crosses a line of a section.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "observe/section.hpp"

namespace softwet {

/// A place where a depth crosses 0, with the direction: +1 into the droplet.
struct Crossing {
  double x;
  int direction;
};

/// Of two neighbours in a row of samples.
inline std::optional<Crossing> crossing_between(const std::vector<double>& x, const double* depth, std::size_t i) {
  const double a = depth[i], b = depth[i + 1];
  if ((a < 0) == (b < 0)) return std::nullopt;
  return Crossing{x[i] + (x[i + 1] - x[i]) * a / (a - b), a < 0 ? 1 : -1};
}

inline std::vector<Crossing> crossings(const std::vector<double>& x, const double* depth) {
  std::vector<Crossing> result;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (const auto c = crossing_between(x, depth, i)) result.push_back(*c);
  return result;
}

/// The one nearest to a place inside the droplet, on the side on which that direction leads into it: outwards from there.
inline std::optional<Crossing> nearest_crossing(const std::vector<double>& x, const double* depth, double inside,
                                                int direction) {
  if (x.size() < 2) return std::nullopt;  // a window at the end of its row
  const int last = static_cast<int>(x.size()) - 2;
  const auto above = std::upper_bound(x.begin(), x.end(), inside);
  for (int i = std::clamp(static_cast<int>(above - x.begin()) - 1, 0, last); i >= 0 && i <= last; i -= direction) {
    const auto c = crossing_between(x, depth, i);
    if (c && c->direction == direction && direction * (inside - c->x) > 0) return c;
  }
  return std::nullopt;
}

/// Neighbours in a row of samples, with whether they reach its ends.
struct Window {
  std::vector<double> x;
  bool has_first, has_last;
  /// Nothing of the row lies farther out on the side on which a direction leads into the droplet.
  bool whole_side(int direction) const { return direction > 0 ? has_first : has_last; }
};

/// Those from the last one before `low` to the first one behind `high`. @param x  in ascending order
inline Window window_of(const std::vector<double>& x, double low, double high) {
  auto first = std::lower_bound(x.begin(), x.end(), low), last = std::upper_bound(first, x.end(), high);
  if (first != x.begin()) --first;
  if (last != x.end()) ++last;
  return {{first, last}, first == x.begin(), last == x.end()};
}

/// The crossing nearest to a place of the window. What lies outside the window is farther away, so that the whole row is
/// sampled only where the window has none.
/// @param depth  of the samples in the window
/// @param depth_of_row  gives that of all samples of the row
template <class Sample>
std::optional<Crossing> nearest_crossing(const Window& window, const double* depth, const std::vector<double>& row,
                                         const Sample& depth_of_row, double inside, int direction) {
  const auto near = nearest_crossing(window.x, depth, inside, direction);
  if (near || window.whole_side(direction)) return near;
  const std::vector<double> all = depth_of_row();
  return nearest_crossing(row, all.data(), inside, direction);
}

/// A crossing at a height, sharpened on the spline itself by the Illinois method (Dowell and Jarratt 1971): the secant, in
/// which an end that stays counts half.
template <int D>
double sharpen(const Section<D>& section, const Crossing& c, double height, double spacing, const Surface& surface) {
  const auto excess = [&](double x) { return c.direction * surface.depth(section.density({x}, {height})[0]); };
  double lo = c.x - spacing, hi = c.x + spacing, at_lo = excess(lo), at_hi = excess(hi), x = c.x;
  if (!(at_lo < 0 && at_hi > 0)) return x;
  for (int i = 0, kept = 0; i < 60 && hi - lo > 1e-14 * spacing; ++i) {
    x = (lo * at_hi - hi * at_lo) / (at_hi - at_lo);
    const double at_x = excess(x);
    if (at_x == 0) return x;
    if (at_x > 0) {
      if (kept < 0) at_lo *= 0.5;
      hi = x, at_hi = at_x, kept = -1;
    } else {
      if (kept > 0) at_hi *= 0.5;
      lo = x, at_lo = at_x, kept = 1;
    }
    if (std::abs(at_x) < 1e-15) return x;
  }
  return x;
}

}  // namespace softwet
