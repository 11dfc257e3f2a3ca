// Rates of what a state has, from states that are moved a little.
#pragma once

#include "field/vector.hpp"

namespace softwet::testing_tools {

/// Derivative of f at 0 by differences of fourth order.
template <class F>
double slope(const F& f, double e) {
  return (8 * (f(e) - f(-e)) - f(2 * e) + f(-2 * e)) / (12 * e);
}

/// y + e x, as a new array.
inline Array plus(const Array& y, double e, const std::vector<double>& x) {
  std::vector<double> v = to_host(y);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += e * x[i];
  return to_device<Array>(v);
}

}  // namespace softwet::testing_tools
