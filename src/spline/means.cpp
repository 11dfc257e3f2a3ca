#include "spline/means.hpp"

namespace softwet {

Living means_of(const Axis& axis, int e, MeanWeight weight) {
  const Gauss rule(axis.degree() + 1);
  Living sum{std::vector<double>(axis.degree() + 1), std::vector<double>(axis.degree() + 1)};
  for (std::size_t q = 0; q < rule.point.size(); ++q) {
    const double x = axis.lower(e) + axis.size(e) * rule.point[q];
    const std::vector<double> values = axis.values(e, x), slopes = axis.slopes(e, x);
    const double middle = axis.lower(e) + axis.size(e) / 2;
    const double share = weight == MeanWeight::radius ? x / middle : 1;
    for (int a = 0; a <= axis.degree(); ++a) {
      sum.values[a] += rule.weight[q] * share * values[a];
      sum.slopes[a] += rule.weight[q] * (share * slopes[a] + (1 - share) / middle * values[a]);
    }
  }
  return sum;
}

}  // namespace softwet
