#include "spline/refinement.hpp"

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

/// The knots of the coarse axis as multiples of half its spacing, so that equal knots of both axes compare equal.
std::vector<double> whole_knots(const Axis& axis, double spacing) {
  std::vector<double> knots = axis.knots();
  for (double& knot : knots) knot = static_cast<double>(static_cast<long>(knot / spacing + (knot < 0 ? -0.5 : 0.5)));
  return knots;
}

}  // namespace

Refinement refine_from_half(const Axis& fine, int least) {
  const int n = fine.elements(), p = fine.degree();
  if (n % 2 != 0 || fine.kink() % 2 != 0 || n / 2 < least) {
    Refinement same{fine, {}, {}};
    for (int i = 0; i < fine.functions(); ++i) {
      same.first.push_back(i);
      same.coefficient.push_back({1.0});
    }
    return same;
  }
  Refinement r{Axis(fine.length(), n / 2, p, fine.periodic(), fine.kink() / 2), {}, {}};
  const std::vector<double> t = whole_knots(fine, fine.spacing()), tau = whole_knots(r.coarse, fine.spacing());
  for (int j = 0; j < r.coarse.functions(); ++j) {
    std::vector<double> row;
    int first = 0;
    if (fine.periodic()) {  // uniform knots: the binomial coefficients over 2^p
      first = 2 * j - p;
      row.push_back(1.0);
      for (int k = 1; k <= p + 1; ++k) row.push_back(row.back() * (p + 2 - k) / k);
      for (double& c : row) c /= 1 << p;
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
