// Rates of a solid in addition to its elasticity, from the numbers of a case.
#pragma once

#include <algorithm>
#include <cmath>

#include "case/gel.hpp"
#include "kernels/foundation/terms.hpp"
#include "kernels/functional/term_integrals.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/fibres.hpp"
#include "kernels/solid/kelvin_voigt.hpp"
#include "scene/equilibrium.hpp"

namespace softwet {

/// Properties of a solid in addition to its elasticity, for bounds of explicit steps: 4/3 eta + zeta, the largest
/// tension of its top face, the modulus lambda_s + 2 G_s of this face, the springs and the dashpots of its bottom, the
/// largest stiffness of needles, and the stiffness that its branches add against fast waves.
struct SolidRates {
  double viscosity = 0, tension = 0, modulus = 0, springs = 0, dashpots = 0, held = 0, branches = 0;
};

/// An upper bound of the stiffness of springs at a point of the solid: needles whose boxes overlap add up.
inline double stiffness_of_needles(const Case& c) {
  const auto overlap = [](const Needle& a, const Needle& b) {
    for (std::size_t d = 0; d < a.lower.size(); ++d)
      if (a.upper[d] <= b.lower[d] || b.upper[d] <= a.lower[d]) return false;
    return true;
  };
  double most = 0;
  for (const Needle& needle : c.needles) {
    double sum = 0;
    for (const Needle& other : c.needles) sum += overlap(needle, other) ? other.stiffness : 0;
    most = std::max(most, sum);
  }
  return most;
}

inline KelvinVoigt viscosity_of(const Substrate& s) {
  return {shear_viscosity(s), s.bulk_viscosity, s.strain == Strain::small ? 0.0 : 1.0};
}

inline Branches branches_of(const Substrate& s) {
  Branches all;
  for (const Branch& branch : all_branches(s)) {
    all.modulus[all.count] = branch.modulus;
    all.time[all.count++] = branch.time;
  }
  return all;
}

/// Calls use(term) for each term of the parts of a case.
template <class Use>
void visit_terms_of_parts(const Case& c, const Use& use) {
  c.parts.each([&](const auto& part) { std::decay_t<decltype(part)>::Terms::of(part, use); });
}

inline SolidRates solid_rates(const Case& c) {
  const Substrate& s = *c.substrate;
  const bool acts = c.fluid && c.fluid->wall_tension == WallTensionModel::acts;
  const double tension =
      acts ? s.surface_tension + surface_tension(*c.fluid) : std::max(s.surface_tension, s.surface_tension_wet);
  const double of_wetting = acts ? c.wetted_modulus() * surface_tension(*c.fluid) : 0;
  SolidRates rates;
  rates.viscosity = viscosity_of(s).rate();
  rates.tension = tension;
  rates.modulus = s.modulus_of_surface() + of_wetting;
  visit_terms_of_parts(c, [&](const auto& term) {
    (HasDissipation<std::decay_t<decltype(term)>> ? rates.dashpots : rates.springs) += term.rate();
  });
  rates.held = stiffness_of_needles(c);
  rates.branches = branches_of(s).weight(0);
  return rates;
}

inline Fibres fibres_of(const Substrate& s, int dimension) {
  const double up = s.fibre.angle * M_PI / 180, around = s.fibre.azimuth * M_PI / 180;
  const Vector<double, 3> direction =
      dimension == 2
          ? Vector<double, 3>{{std::cos(up), std::sin(up), 0}}
          : Vector<double, 3>{{std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)}};
  return {s.fibre.stiffness, direction, s.strain == Strain::small ? 0.0 : 1.0};
}

}  // namespace softwet
