// Places along an axis and samples of a curve, read so that the last digit of a number decides nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace softwet {

/// Whether a place is an end of its axis, but for rounding: within a billionth of an element.
inline bool at_end(double place, double end, double element) { return std::abs(place - end) <= 1e-9 * element; }

/// A place on a periodic axis within its first turn, from 0 to `length`. One that is below 0 by rounding alone is at 0,
/// and not at the end of the turn.
inline double in_first_turn(double place, double length) {
  return std::max(0.0, place - length * std::floor(place / length + 1e-9));
}

/// The number of equal parts, none longer than `longest`; a ratio that is a whole number but for rounding is that
/// number.
inline int parts_no_longer(double length, double longest) {
  return static_cast<int>(std::ceil(length / longest - 1e-6));
}

/// The largest of equidistant samples, refined by the parabola through each inner one and its neighbours, halfway to
/// these. Where two samples are equally large, it does not depend on which one the last digit prefers.
inline double top_of(const std::vector<double>& value) {
  double top = std::max(value.front(), value.back());
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    const double slope = 0.5 * (value[i + 1] - value[i - 1]), bend = value[i + 1] - 2 * value[i] + value[i - 1];
    const double vertex = bend < 0 ? std::clamp(-slope / bend, -0.5, 0.5) : 0;
    top = std::max(top, value[i] + (slope + 0.5 * bend * vertex) * vertex);
  }
  return top;
}

}  // namespace softwet
