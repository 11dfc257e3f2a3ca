#include "spline/refinement.hpp"

#include <cmath>

namespace softwet {

namespace {

/// Coefficient of the fine B-spline i in the coarse one j, both of `degree`, by recursion over the degree.
double oslo(const std::vector<double>& coarse, const std::vector<double>& fine, int j, int i, int degree) {
  if (degree == 0) return coarse[j] <= fine[i] && fine[i] < coarse[j + 1] ? 1.0 : 0.0;
  const double x = fine[i + degree];
  const double left = coarse[j + degree] - coarse[j], right = coarse[j + degree + 1] - coarse[j + 1];
  double sum = 0;
  if (left > 0) sum += (x - coarse[j]) / left * oslo(coarse, fine, j, i, degree - 1);
  if (right > 0) sum += (coarse[j + degree + 1] - x) / right * oslo(coarse, fine, j + 1, i, degree - 1);
  return sum;
}

/// Knots that are equal for both axes where they are at the same place: knots of equal elements are multiples of a fine
/// length.
std::vector<double> comparable_knots(const Axis& axis, double spacing) {
  std::vector<double> knots = axis.knots();
  if (axis.graded()) return knots;
  for (double& knot : knots) knot = static_cast<double>(static_cast<long>(knot / spacing + (knot < 0 ? -0.5 : 0.5)));
  return knots;
}

/// Whether two neighbours can be joined everywhere. Where elements are graded, one may be left over at an end.
bool can_be_halved(const Axis& fine, int least) {
  const int n = fine.elements();
  if (n / 2 < least) return false;
  return n % 2 == 0 ? fine.graded() || fine.kink() % 2 == 0 : fine.graded() && !fine.periodic();
}

/// Joins neighbours from the kink outwards. A joint that is no end of the joined elements is one of the fine functions
/// alone.
Axis halved(const Axis& fine) {
  const int n = fine.elements(), kink = fine.kink();
  const int joint = (fine.joint() - kink) % 2 == 0 ? fine.joint() : 0;
  if (!fine.graded()) return {fine.length(), n / 2, fine.degree(), fine.kind(), kink / 2, joint / 2};
  std::vector<double> breaks;
  for (int i = 0; i <= n; ++i)
    if (i == 0 || i == n || (i - kink) % 2 == 0) breaks.push_back(fine.breaks()[i]);
  return {breaks, fine.degree(), fine.kind(), (kink + 1) / 2, (joint + 1) / 2};
}

/// Coefficients of the fine functions 2 j - p, ..., 2 j + 1 in the coarse one j around a periodic axis.
std::vector<double> around(const Axis& fine, int j) {
  const int p = fine.degree(), n = fine.elements();
  std::vector<double> row{1.0};
  if (!fine.graded()) {  // the binomial coefficients over 2^p
    for (int k = 1; k <= p + 1; ++k) row.push_back(row.back() * (p + 2 - k) / k);
    for (double& c : row) c /= 1 << p;
    return row;
  }
  std::vector<double> knots, every_second;  // fine break 2 (j - p) and those that follow, from 0 on
  for (int k = 0; k <= 2 * p + 2; ++k) {
    const int e = 2 * (j - p) + k, turns = static_cast<int>(std::floor(e / static_cast<double>(n)));
    knots.push_back(fine.breaks()[e - turns * n] + turns * fine.length());
    if (k % 2 == 0) every_second.push_back(knots.back());
  }
  row.clear();
  for (int k = 0; k <= p + 1; ++k) row.push_back(oslo(every_second, knots, 0, k, p));
  return row;
}

}  // namespace

Refinement refine_from_half(const Axis& fine, int least) {
  const int p = fine.degree();
  if (!can_be_halved(fine, least)) {
    Refinement same{fine, {}, {}};
    for (int i = 0; i < fine.functions(); ++i) {
      same.first.push_back(i);
      same.coefficient.push_back({1.0});
    }
    return same;
  }
  Refinement r{halved(fine), {}, {}};
  const std::vector<double> t = comparable_knots(fine, fine.spacing()),
                            tau = comparable_knots(r.coarse, fine.spacing());
  for (int j = 0; j < r.coarse.functions(); ++j) {
    std::vector<double> row;
    int first = 0;
    if (fine.periodic()) {
      first = 2 * j - p;
      row = around(fine, j);
    } else {
      for (int i = 0; i < fine.functions(); ++i) {
        const double c = oslo(tau, t, j, i, p);
        if (c == 0) continue;
        if (row.empty()) first = i;
        row.resize(i - first, 0.0);
        row.push_back(c);
      }
    }
    r.first.push_back(first);
    r.coefficient.push_back(row);
  }
  return r;
}

}  // namespace softwet
