// What a solid has beside its elasticity, from the numbers of a case.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/equilibrium.hpp"
#include "model/model.hpp"

namespace softwet {

inline SolidRates solid_rates(const Case& c) {
  const Substrate& s = *c.substrate;
  const bool acts = c.fluid && c.fluid->wall_tension == WallTensionModel::acts;
  const double tension =
      acts ? s.surface_tension + surface_tension(*c.fluid) : std::max(s.surface_tension, s.surface_tension_wet);
  const std::vector<double>& springs = c.boundary.foundation;
  return {4.0 / 3 * s.viscosity + s.bulk_viscosity, tension, s.modulus_of_surface(),
          springs.empty() ? 0 : std::max(springs[0], springs[1])};
}

inline Fibres fibres_of(const Substrate& s, int dimension) {
  const double up = s.fibre.angle * M_PI / 180, around = s.fibre.azimuth * M_PI / 180;
  const Vector<double, 3> direction =
      dimension == 2
          ? Vector<double, 3>{{std::cos(up), std::sin(up), 0}}
          : Vector<double, 3>{{std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)}};
  return {s.fibre.stiffness, direction, s.strain == "small" ? 0.0 : 1.0};
}

}  // namespace softwet
