// The fields that [initial] gives at each point, in place of the fields of droplets and films.
#pragma once

#include <algorithm>

#include "scene/earlier_state.hpp"
#include "scene/greville_points.hpp"

namespace softwet {

/// Sets the rows [first, first + rows) of a component.
template <int D>
void give(const Layout<D>& l, const Profile& profile, int first, int rows, double* values) {
  const std::vector<double> given = control_values(l, profile, first, rows);
  std::copy(given.begin(), given.end(), values);
}

/// Density and velocity of the fluid. The wall of a solid, which both have in common, stays at rest.
template <int D>
void give_fluid(const Initial& given, const Layout<D>& l, std::vector<double>& unknown) {
  if (given.density) give(l, *given.density, l.wall_row, l.fluid_rows(), &unknown[l.density_offset()]);
  const int first = l.has_solid ? l.wall_row + 1 : l.wall_row;
  for (std::size_t d = 0; d < given.velocity.size(); ++d)
    give(l, given.velocity[d], first, l.rows - first, &unknown[l.velocity_offset(d) + first * l.row_size]);
}

/// Whether a side of the domain prescribes component `own` of the displacement at a Greville point.
template <int D>
bool is_held(const Case& c, const double* x, int own) {
  for (int d = 0; d < D; ++d)
    for (int end : {0, 1}) {
      const double side_at = end == 0 ? 0 : c.domain.size[d];
      if (std::abs(x[d] - side_at) < 1e-9 * c.domain.size[d] && holds(c.boundary.side[d][end], own, d)) return true;
    }
  return false;
}

template <int D>
void give_solid(const Case& c, const Layout<D>& l, std::vector<double>& displacement) {
  for (std::size_t d = 0; d < c.initial->displacement.size(); ++d)
    at_greville_points(l, 0, l.solid_rows(), [&](int i, const double* x) {
      if (!is_held<D>(c, x, static_cast<int>(d)))
        displacement[l.displacement_offset(d) + i] = c.initial->displacement[d].at(place_inside(l, x));
    });
}

}  // namespace softwet
