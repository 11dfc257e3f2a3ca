// Control values from functions of the place: each is the value at its Greville point.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "field/layout.hpp"

namespace softwet {

/// Calls visit(i, x) for each control value of a component with rows [first, first + rows): its Greville point. A
/// control value equal to a function there is a positive approximation, so that it cannot undershoot. Round a periodic axis x may
/// lie outside of the domain.
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

/// The place of a Greville point inside of the domain, for a formula.
template <int D>
std::array<double, 3> place_inside(const Layout<D>& l, const double* x) {
  std::array<double, 3> place{};
  for (int d = 0; d < D; ++d) {
    const double length = l.axis[d].length();
    place[d] = l.axis[d].periodic() ? x[d] - length * std::floor(x[d] / length) : x[d];
  }
  return place;
}

/// Control values of a profile on the rows [first, first + rows), in the order of a component.
template <int D>
std::vector<double> control_values(const Layout<D>& l, const Profile& profile, int first, int rows) {
  std::vector<double> values(static_cast<std::size_t>(rows) * l.row_size);
  at_greville_points(l, first, rows, [&](int i, const double* x) { values[i] = profile.at(place_inside(l, x)); });
  return values;
}

}  // namespace softwet
