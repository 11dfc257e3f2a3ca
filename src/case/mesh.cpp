#include "case/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

constexpr double worth_grading = 0.95;  ///< share of the elements of an axis above which they stay equal
constexpr double rounding = 1e-9;       ///< of a fine length

/// Lengths that grow by `ratio` from `fine` to at most `most`.
std::vector<double> growing(double fine, double most, double ratio, int count) {
  std::vector<double> lengths;
  for (double x = fine; static_cast<int>(lengths.size()) < count;) lengths.push_back(x = std::min(x * ratio, most));
  return lengths;
}

double total_of(const std::vector<double>& lengths) {
  double total = 0;
  for (const double x : lengths) total += x;
  return total;
}

/// The fewest lengths that fill `room`, by the smallest ratio that does. They begin beside an element of the length `fine`.
std::vector<double> fill(double room, double fine, const Grading& grading) {
  if (room < rounding * fine) return {};
  const double most = grading.coarsest * fine;
  int count = std::max(1, static_cast<int>(room / most));
  while (total_of(growing(fine, most, grading.ratio, count)) < room - rounding * fine) ++count;
  double low = 1, high = grading.ratio;
  for (int i = 0; i < 100; ++i) {
    const double ratio = 0.5 * (low + high);
    (total_of(growing(fine, most, ratio, count)) < room ? low : high) = ratio;
  }
  std::vector<double> lengths = growing(fine, most, high, count);
  const double scale = room / total_of(lengths);
  for (double& x : lengths) x *= scale;
  return lengths;
}

}  // namespace

double fine_length(const Case& c, int axis) { return c.domain.size[axis] / c.domain.elements[axis]; }

std::vector<double> graded_breaks(const Case& c, int axis) {
  const Grading& grading = c.domain.grading;
  const auto d = static_cast<std::size_t>(axis);
  if (grading.lower.size() <= d || grading.upper.size() <= d) return {};
  const double h = fine_length(c, axis), length = c.domain.size[axis];
  const int all = c.domain.elements[axis];
  const int first = std::clamp(static_cast<int>(std::floor(grading.lower[d] / h + rounding)), 0, all - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(grading.upper[d] / h - rounding)), first + 1, all);
  std::vector<double> below = fill(length * first / all, h, grading);
  const std::vector<double> above = fill(length - length * last / all, h, grading);
  if (below.size() + above.size() + (last - first) > worth_grading * all) return {};
  std::vector<double> breaks;
  double x = length * first / all;
  for (const double step : below) breaks.push_back(x -= step);
  if (!breaks.empty()) breaks.back() = 0;
  std::reverse(breaks.begin(), breaks.end());
  for (int i = first; i <= last; ++i) breaks.push_back(length * i / all);
  for (const double step : above) breaks.push_back(breaks.back() + step);
  breaks.back() = length;
  return breaks;
}

FinePart fine_part(const Case& c, int axis) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::vector<double> breaks = graded_breaks(c, axis);
  const double h = fine_length(c, axis) * (1 + 1e-6);
  FinePart part{far, -far};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i + 1] - breaks[i] > h) continue;
    part.low = std::min(part.low, breaks[i]);
    part.high = breaks[i + 1];
  }
  if (breaks.empty() || part.low == breaks.front()) part.low = -far;
  if (breaks.empty() || part.high == breaks.back()) part.high = far;
  return part;
}

int elements_along(const Case& c, int axis) {
  const std::vector<double> breaks = graded_breaks(c, axis);
  return breaks.empty() ? c.domain.elements[axis] : static_cast<int>(breaks.size()) - 1;
}

namespace {

/// Rows of elements whose ends are nearest to a height.
int rows_below(const Case& c, double height) {
  const int vertical = c.dimension() - 1;
  const std::vector<double> breaks = graded_breaks(c, vertical);
  if (breaks.empty()) return static_cast<int>(std::lround(height / fine_length(c, vertical)));
  const auto nearest = std::min_element(
      breaks.begin(), breaks.end(), [&](double a, double b) { return std::abs(a - height) < std::abs(b - height); });
  return static_cast<int>(nearest - breaks.begin());
}

}  // namespace

int solid_elements(const Case& c) { return c.substrate ? rows_below(c, c.substrate->thickness) : 0; }

int joint_element(const Case& c) { return c.substrate ? rows_below(c, c.substrate->joint) : 0; }

double end_of_row(const Case& c, int row) {
  const int vertical = c.dimension() - 1;
  const std::vector<double> breaks = graded_breaks(c, vertical);
  return breaks.empty() ? fine_length(c, vertical) * row : breaks[row];
}

double share_of_elements(const Case& c) {
  double share = 1;
  for (int d = 0; d < c.dimension(); ++d) share *= elements_along(c, d) / static_cast<double>(c.domain.elements[d]);
  return share;
}

}  // namespace softwet
