#include "spline/sampling.hpp"

#include <cmath>

namespace softwet {
namespace {

/// An element under a function: its number, the function's number on it, and how far it is moved around a periodic
/// axis.
struct Support {
  int element, function;
  double moved;
};

std::vector<Support> support_of(const Axis& axis, int function) {
  std::vector<Support> all;
  const int n = axis.elements(), p = axis.degree();
  if (axis.periodic()) {
    for (int e = function - p; e <= function; ++e) {
      const int turns = static_cast<int>(std::floor(e / static_cast<double>(n)));
      all.push_back({e - turns * n, function - e, turns * axis.length()});
    }
    return all;
  }
  for (int e = 0; e < n; ++e)
    if (axis.span(e) <= function && function <= axis.span(e) + p) all.push_back({e, function - axis.span(e), 0});
  return all;
}

bool are_equal(const Axis& axis, const std::vector<Support>& support) {
  const double first = axis.size(support.front().element);
  for (const Support& s : support)
    if (std::abs(axis.size(s.element) - first) > 1e-9 * first) return false;
  return true;
}

}  // namespace

std::vector<Samples> samples_of(const Axis& axis) {
  const Gauss gauss(axis.degree() + 1);
  std::vector<Samples> all;
  for (int i = 0; i < axis.functions(); ++i) {
    Samples& samples = all.emplace_back();
    const std::vector<Support> support = support_of(axis, i);
    if (!axis.graded() || are_equal(axis, support)) {
      samples = {{axis.greville(i)}, {1.0}};
      continue;
    }
    double total = 0;
    for (const Support& s : support)
      for (std::size_t q = 0; q < gauss.point.size(); ++q) {
        const double length = axis.size(s.element), x = axis.lower(s.element) + length * gauss.point[q];
        const double part = length * gauss.weight[q] * axis.values(s.element, x)[s.function] * axis.weight(x);
        samples.place.push_back(x + s.moved);
        samples.weight.push_back(part);
        total += part;
      }
    for (double& weight : samples.weight) weight /= total;
  }
  return all;
}

}  // namespace softwet
