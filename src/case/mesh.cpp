#include "case/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

constexpr double worth_grading = 0.95;  ///< share of the elements of an axis above which they stay equal
constexpr double rounding = 1e-9;       ///< of a fine length

/// Lengths between two elements of the lengths `from` and `to`: from both ends they grow by `ratio` to at most `most`,
/// the shorter end first.
std::vector<double> growing(double from, double to, double most, double ratio, int count) {
  std::vector<double> lengths, behind;
  double next = std::min(from * ratio, most), next_behind = std::min(to * ratio, most);
  while (static_cast<int>(lengths.size() + behind.size()) < count) {
    if (next <= next_behind) {
      lengths.push_back(next);
      next = std::min(next * ratio, most);
    } else {
      behind.push_back(next_behind);
      next_behind = std::min(next_behind * ratio, most);
    }
  }
  lengths.insert(lengths.end(), behind.rbegin(), behind.rend());
  return lengths;
}

double total_of(const std::vector<double>& lengths) {
  double total = 0;
  for (const double x : lengths) total += x;
  return total;
}

/// The elements of an axis before it is graded, and what grades them.
struct Line {
  double length, fine;
  int all;
  const Grading& grading;

  double longest() const { return grading.coarsest * fine; }
  double end(int element) const { return length * element / all; }
};

/// The fewest lengths that fill `room`, by the smallest ratio that does, between a fine element and one of the length
/// `to`.
std::vector<double> fill(const Line& line, double room, double to) {
  const double fine = line.fine, most = line.longest();
  if (room < rounding * fine) return {};
  int count = std::max(1, static_cast<int>(room / most));
  while (total_of(growing(fine, to, most, line.grading.ratio, count)) < room - rounding * fine) ++count;
  double low = 1, high = line.grading.ratio;
  for (int i = 0; i < 100; ++i) {
    const double ratio = 0.5 * (low + high);
    (total_of(growing(fine, to, most, ratio, count)) < room ? low : high) = ratio;
  }
  std::vector<double> lengths = growing(fine, to, most, high, count);
  const double scale = room / total_of(lengths);
  for (double& x : lengths) x *= scale;
  return lengths;
}

/// The fine elements [first, last) of an axis, and the lengths of those below and above, from the fine ones outwards.
struct Beside {
  int first, last;
  std::vector<double> below, above;
};

/// Whether the elements at both ends of a periodic axis, which are neighbours, keep the ratio.
bool holds_across_seam(const Line& line, const Beside& beside) {
  const double a = beside.below.empty() ? line.fine : beside.below.back();
  const double b = beside.above.empty() ? line.fine : beside.above.back();
  return std::max(a, b) <= (1 + rounding) * line.grading.ratio * std::min(a, b);
}

/// Elements that grow around a periodic end: from the nearer end of the fine ones up to the seam, and from there and
/// from the other end towards each other. Where this does not keep the ratio, fine elements reach nearer to the seam,
/// in the end up to it.
Beside around_seam(const Line& line, int first, int last) {
  const bool below_is_shorter = first < line.all - last;
  for (;; below_is_shorter ? --first : ++last) {
    const double below = line.end(first), above = line.length - line.end(last);
    std::vector<double> near = fill(line, below_is_shorter ? below : above, line.longest());
    std::vector<double> far = fill(line, below_is_shorter ? above : below, near.empty() ? line.fine : near.back());
    if (!below_is_shorter) std::swap(near, far);
    Beside beside{first, last, near, far};
    if (holds_across_seam(line, beside)) return beside;
  }
}

Beside elements_beside(const Line& line, int first, int last, bool periodic) {
  Beside beside{first, last, fill(line, line.end(first), line.longest()),
                fill(line, line.length - line.end(last), line.longest())};
  return periodic && !holds_across_seam(line, beside) ? around_seam(line, first, last) : beside;
}

/// Ends of elements of which all from `first` around the periodic end to `last` are fine.
std::vector<double> breaks_around(const Line& line, int first, int last) {
  const std::vector<double> between = fill(line, line.end(first) - line.end(last), line.fine);
  std::vector<double> breaks;
  for (int i = 0; i <= last; ++i) breaks.push_back(line.end(i));
  for (const double step : between) breaks.push_back(breaks.back() + step);
  breaks.pop_back();
  for (int i = first; i <= line.all; ++i) breaks.push_back(line.end(i));
  return breaks;
}

std::vector<double> breaks_of(const Line& line, const Beside& beside) {
  std::vector<double> breaks;
  double x = line.end(beside.first);
  for (const double step : beside.below) breaks.push_back(x -= step);
  if (!breaks.empty()) breaks.back() = 0;
  std::reverse(breaks.begin(), breaks.end());
  for (int i = beside.first; i <= beside.last; ++i) breaks.push_back(line.end(i));
  for (const double step : beside.above) breaks.push_back(breaks.back() + step);
  breaks.back() = line.length;
  return breaks;
}

bool is_periodic(const Case& c, int axis) { return c.boundary.side[axis][0] == Side::periodic; }

}  // namespace

double fine_length(const Case& c, int axis) { return c.domain.size[axis] / c.domain.elements[axis]; }

std::vector<double> graded_breaks(const Case& c, int axis) {
  const Grading& grading = c.domain.grading;
  const auto d = static_cast<std::size_t>(axis);
  if (grading.lower.size() <= d || grading.upper.size() <= d) return {};
  const Line line{c.domain.size[axis], fine_length(c, axis), c.domain.elements[axis], grading};
  int first = static_cast<int>(std::floor(grading.lower[d] / line.fine + rounding));
  int last = static_cast<int>(std::ceil(grading.upper[d] / line.fine - rounding));
  const bool periodic = is_periodic(c, axis);
  if (periodic) {
    if (last - first >= line.all) return {};
    const int turns = static_cast<int>(std::floor(static_cast<double>(first) / line.all));
    first -= turns * line.all, last -= turns * line.all;
  }
  std::vector<double> breaks;
  if (periodic && last > line.all) {
    breaks = breaks_around(line, first, last - line.all);
  } else {
    first = std::clamp(first, 0, line.all - 1);
    last = std::clamp(last, first + 1, line.all);
    breaks = breaks_of(line, elements_beside(line, first, last, periodic));
  }
  if (static_cast<double>(breaks.size()) - 1 > worth_grading * line.all) return {};
  return breaks;
}

FinePart fine_part(const Case& c, int axis) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::vector<double> breaks = graded_breaks(c, axis);
  if (breaks.empty()) return {-far, far};
  const int count = static_cast<int>(breaks.size()) - 1;
  const double longest = fine_length(c, axis) * (1 + 1e-6);
  const auto is_fine = [&](int i) { return breaks[i % count + 1] - breaks[i % count] <= longest; };
  const bool periodic = is_periodic(c, axis);
  int first = 0;
  while (periodic && is_fine(first)) ++first;  // the fine elements may reach around the end
  while (!is_fine(first)) ++first;
  first %= count;
  int last = first;
  while ((periodic || last < count) && is_fine(last)) ++last;
  if (periodic) return {breaks[first], breaks[last % count] + last / count * breaks.back()};
  return {first == 0 ? -far : breaks[first], last == count ? far : breaks[last]};
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
