#include "foresight/steps_foreseen.hpp"

#include <algorithm>
#include <cmath>

#include "case/mesh.hpp"
#include "foresight/measured.hpp"
#include "scene/fluid_of.hpp"
#include "scene/prestretch.hpp"
#include "scene/solid_rates.hpp"
#include "time/explicit/solid_points.hpp"

namespace softwet {
namespace {

double fastest_droplet(const Case& c) {
  double fastest = 0;
  for (const Droplet& droplet : c.droplets) {
    double square = 0;
    for (const double v : droplet.velocity) square += v * v;
    fastest = std::max(fastest, std::sqrt(square));
  }
  return fastest;
}

/// Whether a droplet stays away from all sides, where the mesh is stiffer: none touches one, and none is thrown at one.
bool stays_inside(const Case& c) {
  const auto inside = [&](const Droplet& droplet) {
    for (int d = 0; d < c.dimension(); ++d) {
      const double low = d == c.dimension() - 1 ? c.wall_height() : 0, x = droplet.centre[d];
      if (x - droplet.radius < low || x + droplet.radius > c.domain.size[d]) return false;
    }
    return true;
  };
  return fastest_droplet(c) == 0 && c.films.empty() && !c.gives_density() && !c.droplets.empty() &&
         c.fluid->ambient == Phase::vapour && std::all_of(c.droplets.begin(), c.droplets.end(), inside);
}

double rate_of_fluid(const Case& c, const MassSymbols& at_ends, double shortest) {
  const Coexistence flat = coexistence(c.fluid->temperature);
  const NavierStokesKorteweg fluid = fluid_of(*c.fluid, flat, shortest);
  const MassSymbols of_liquid = stays_inside(c) ? inside_symbols(c.domain.degree, MassKind::corrected) : at_ends;
  const auto rate = [&](double density, const MassSymbols& symbols) {
    double found[step_points::mechanisms] = {};
    step_points::rates_of_fluid<double>(fluid, {0.0, symbols, symbols}, StepFormula::kick_drift, 1, density, density,
                                        fastest_droplet(c), 1 / shortest, found);
    return found[step_points::combined];
  };
  return std::max(rate(flat.density_vapour, at_ends), rate(flat.density_liquid, of_liquid));
}

/// Whether nothing holds the velocity at an end of an axis, away from the ends of the other axes.
bool has_free_end(const Case& c, int axis) {
  const auto& ends = c.boundary.side[axis];
  return !c.fluid && (ends[0] == Side::free || ends[1] == Side::free);
}

/// Largest rate of a solid whose displacement is 0.
template <int D, bool Axial, class Material>
double rate_of_material(const Case& c, const MassSymbols& symbols, double shortest) {
  using Bound = step_points::SolidBound<D, Material, Axial>;
  const Substrate& s = *c.substrate;
  bool free_axis[D];
  for (int d = 0; d < D; ++d) free_axis[d] = has_free_end(c, d);
  const LameParameters stiffness = stiffest_of(s);
  const Prestretch prestretch = prestretch_of(c, stiffness);
  Bound bound({{stiffness}, s.density}, fibres_of(s, D).after(prestretch), StepFormula::kick_drift, solid_rates(c),
              symbols, 1, shortest, free_axis);
  bound.prestretch = prestretch;
  const auto rate = [&](step_points::SolidPlace place) {
    double found[step_points::mechanisms] = {};
    bound.rates({}, place, found);
    return found[step_points::combined];
  };
  return std::max(rate(step_points::SolidPlace::face), rate(step_points::SolidPlace::bottom));
}

/// Rate of any material: all materials are alike where nothing is stretched.
template <int D, bool Axial>
double rate_of_solid(const Case& c, const MassSymbols& symbols, double shortest) {
  if (c.substrate->prestretch.empty() || c.substrate->material != MaterialModel::neo_hookean)
    return rate_of_material<D, Axial, SaintVenantKirchhoff>(c, symbols, shortest);
  return rate_of_material<D, Axial, NeoHookean>(c, symbols, shortest);
}

double rate_of_solid(const Case& c, const MassSymbols& symbols, double shortest) {
  if (c.axisymmetric()) return rate_of_solid<2, true>(c, symbols, shortest);
  return c.dimension() == 2 ? rate_of_solid<2, false>(c, symbols, shortest)
                            : rate_of_solid<3, false>(c, symbols, shortest);
}

/// The fewest elements along an axis, as for the bound: see fewest_elements in step_bound.cpp.
int fewest_elements(const Case& c) {
  const int up = c.dimension() - 1, of_solid = c.substrate ? static_cast<int>(std::lround(c.rows_of_solid())) : 0;
  std::vector<int> all{of_solid, c.domain.elements[up] - of_solid};
  for (int d = 0; d < up; ++d)
    if (c.boundary.side[d][0] != Side::periodic) all.push_back(c.domain.elements[d]);
  return fewest_that_matter(all);
}

JoinedElements joined_elements(const Case& c) {
  const int joint = joint_element(c);
  return joint == 0 ? JoinedElements{} : JoinedElements{joint, solid_elements(c) - joint};
}

}  // namespace

double explicit_steps_foreseen(const Case& c) {
  const double shortest = c.shortest();
  const int degree = c.domain.degree;
  const MassSymbols symbols =
      with_joint(end_symbols(degree, MassKind::corrected, fewest_elements(c), c.domain.coordinates), degree,
                 MassKind::corrected, joined_elements(c));
  double rate = 0;
  if (c.fluid) rate = std::max(rate, rate_of_fluid(c, symbols, shortest));
  if (c.substrate) rate = std::max(rate, rate_of_solid(c, symbols, shortest));
  const double start = c.run_start() - c.clock_zero();
  return (c.time.end - start) * rate / c.time.safety;
}

double most_explicit_steps(int dimension) {
  return dimension == 2 ? measured::most_explicit_steps_2d : measured::most_explicit_steps_3d;
}

}  // namespace softwet
