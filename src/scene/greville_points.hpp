// Control values from functions of position.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "field/layout.hpp"
#include "spline/sampling.hpp"

namespace softwet {

/// Calls visit(i, x) for each control value of a component with rows [first, first + rows): its Greville point. Round a
/// periodic axis x may lie outside of the domain.
template <int D, class Visit>
void at_greville_points(const Layout<D>& l, int first, int rows, const Visit& visit) {
  for (int i = 0; i < rows * l.row_size; ++i) {
    double x[D];
    int rest = i;
    for (int d = 0; d < D; ++d) {
      const int n = d < D - 1 ? l.extent(d) : rows;
      x[d] = l.axis[d].greville(l.function(rest % n, d) + (d == D - 1 ? first : 0));
      rest /= n;
    }
    visit(i, x);
  }
}

/// Calls visit(i, x, weight) for each sample of each control value i of a component with rows [first, first + rows):
/// the sum of weight f(x) is a control value of f (spline/sampling.hpp).
template <int D, class Visit>
void at_samples(const Layout<D>& l, int first, int rows, const Visit& visit) {
  std::array<std::vector<Samples>, D> of_axis;
  for (int d = 0; d < D; ++d) of_axis[d] = samples_of(l.axis[d]);
  for (int i = 0; i < rows * l.row_size; ++i) {
    const Samples* samples[D];
    std::size_t count = 1;
    for (int d = 0, rest = i; d < D; ++d) {
      const int n = d < D - 1 ? l.extent(d) : rows;
      samples[d] = &of_axis[d][l.function(rest % n, d) + (d == D - 1 ? first : 0)];
      count *= samples[d]->place.size();
      rest /= n;
    }
    for (std::size_t k = 0; k < count; ++k) {
      double x[D], weight = 1;
      std::size_t rest = k;
      for (int d = 0; d < D; ++d) {
        const std::size_t n = samples[d]->place.size();
        x[d] = samples[d]->place[rest % n];
        weight *= samples[d]->weight[rest % n];
        rest /= n;
      }
      visit(i, x, weight);
    }
  }
}

/// A position inside of the domain, for a formula.
template <int D>
std::array<double, 3> place_inside(const Layout<D>& l, const double* x) {
  std::array<double, 3> place{};
  for (int d = 0; d < D; ++d) {
    const double length = l.axis[d].length();
    place[d] = l.axis[d].periodic() ? x[d] - length * std::floor(x[d] / length) : x[d];
  }
  return place;
}

/// Control values of a function of position on the rows [first, first + rows), in the order of a component.
template <int D, class Function>
std::vector<double> control_values(const Layout<D>& l, const Function& function, int first, int rows) {
  std::vector<double> values(static_cast<std::size_t>(rows) * l.row_size, 0.0);
  at_samples(l, first, rows,
             [&](int i, const double* x, double weight) { values[i] += weight * function(place_inside(l, x)); });
  return values;
}
template <int D>
std::vector<double> control_values(const Layout<D>& l, const Profile& profile, int first, int rows) {
  return control_values(
      l, [&](const std::array<double, 3>& x) { return profile.at(x); }, first, rows);
}

}  // namespace softwet
