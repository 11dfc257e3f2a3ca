// Where the surface of droplets crosses a line of a section, at a point of the spline or in a mean over elements.
#pragma once

#include <algorithm>
#include <array>
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

/// The crossing between two neighbours in a row of samples.
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

/// The crossing nearest to a place inside the droplet, on the side on which the direction leads into it: outwards from
/// there.
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

/// The samples from the last one before `low` to the first one behind `high`. @param x  in ascending order
inline Window window_of(const std::vector<double>& x, double low, double high) {
  auto first = std::lower_bound(x.begin(), x.end(), low), last = std::upper_bound(first, x.end(), high);
  if (first != x.begin()) --first;
  if (last != x.end()) ++last;
  return {{first, last}, first == x.begin(), last == x.end()};
}

/// The crossing nearest to a place of the window. Samples outside the window are farther away, so that the whole row is
/// sampled only where the window has none.
/// @param depth  of the samples in the window
/// @param depth_of_row  returns the depth of all samples of the row
template <class Sample>
std::optional<Crossing> nearest_crossing(const Window& window, const double* depth, const std::vector<double>& row,
                                         const Sample& depth_of_row, double inside, int direction) {
  const auto near = nearest_crossing(window.x, depth, inside, direction);
  if (near || window.whole_side(direction)) return near;
  const std::vector<double> all = depth_of_row();
  return nearest_crossing(row, all.data(), inside, direction);
}

/// Where a function that is negative at `low` and positive at `high` is 0, by the Illinois method (Dowell and Jarratt
/// 1971): the secant, in which an end that stays counts half. Empty where the signs are others. @param length  that
/// counts as one
template <class Function>
std::optional<double> zero_between(const Function& function, double low, double high, double length) {
  double at_low = function(low), at_high = function(high);
  if (!(at_low < 0 && at_high > 0)) return std::nullopt;
  double x = low;
  for (int i = 0, kept = 0; i < 60 && high - low > 1e-14 * length; ++i) {
    x = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_x = function(x);
    if (std::abs(at_x) < 1e-15) return x;
    if (at_x > 0) {
      if (kept < 0) at_low *= 0.5;
      high = x, at_high = at_x, kept = -1;
    } else {
      if (kept > 0) at_high *= 0.5;
      low = x, at_low = at_x, kept = 1;
    }
  }
  return x;
}

/// A crossing at a height, sharpened on the spline itself.
template <int D>
double sharpen(const Section<D>& section, const Crossing& c, double height, double spacing, const Surface& surface) {
  const auto excess = [&](double x) { return c.direction * surface.depth(section.density({x}, {height})[0]); };
  return zero_between(excess, c.x - spacing, c.x + spacing, spacing).value_or(c.x);
}

/// A weighted mean along a line, over two elements to each side, that leaves parabolas as they are. A spline swings
/// about the interface that it resolves, with the period of an element, and such a mean of splines cancels it (Bramble
/// and Schatz, Math. Comp. 31, 94, 1977: the kernel of three hat functions, here as a sum over equidistant places).
struct MeanOverElements {
  static constexpr int parts = 8;          ///< of an element
  static constexpr int reach = 2 * parts;  ///< places to each side
  std::array<double, 2 * reach + 1> weight{};

  constexpr MeanOverElements() {
    const auto hat = [](int k) { return std::max(0, parts - (k < 0 ? -k : k)) / double(parts * parts); };
    const double side = (parts * parts - 1) / (12.0 * parts * parts);  // half the second moment of the sum of one hat
    for (int k = -reach; k <= reach; ++k)
      weight[k + reach] = (1 + 2 * side) * hat(k) - side * (hat(k - parts) + hat(k + parts));
  }

  /// @param element  length of an element;  @param values  returns values at many places
  template <class Values>
  double operator()(const Values& values, double x, double element) const {
    const std::vector<double> at = values(equidistant(x - 2 * element, x + 2 * element, 2 * reach));
    double sum = 0;
    for (std::size_t k = 0; k < at.size(); ++k) sum += weight[k] * at[k];
    return sum;
  }
};

/// Where the mean depth around a crossing is 0; the sharpened crossing itself where a side of the domain or another
/// crossing is so near that there is no mean. @param element  length of an element
template <int D>
double sharpen_mean(const Section<D>& section, const Crossing& c, double height, double element,
                    const Surface& surface) {
  constexpr MeanOverElements mean;
  const double sharp = sharpen(section, c, height, element / 4, surface), beside = element / 2;
  const Reach& reach = section.reach();
  double room = 2 * element + beside;
  if (reach.low_is_side) room = std::min(room, sharp - reach.low);
  if (reach.high_is_side) room = std::min(room, reach.high - sharp);
  const double part = room / (2 * element + beside);
  const auto depth = [&](const std::vector<double>& x) { return surface.depth(section.density(x, {height})); };
  const auto excess = [&](double x) { return c.direction * mean(depth, x, part * element); };
  return zero_between(excess, sharp - part * beside, sharp + part * beside, element).value_or(sharp);
}

}  // namespace softwet
