#include "foresight/forecast.hpp"

#include <algorithm>
#include <cmath>

#include "case/cap.hpp"
#include "case/text.hpp"
#include "foresight/distances.hpp"
#include "foresight/measured.hpp"
#include "kernels/solid/isotropic.hpp"
#include "scene/equilibrium.hpp"
#include "scene/groups.hpp"
#include "scene/prestretch.hpp"

namespace softwet {
namespace {

/// (dV/dR) / R^(D-1) of a droplet: of a disc 2 pi, of a ball 4 pi, less for a cap and for a half on a slip side, which
/// an axis of symmetry is not.
double growth(const Case& c, const Droplet& droplet) {
  const double pi = std::acos(-1.0), cosine = sits_on_wall(c, droplet) ? cap_cosine(c, droplet) : -1;
  const double angle = std::acos(cosine);
  double whole = c.dimension_of_droplets() == 2 ? 2 * (angle - std::sin(angle) * cosine)
                                                : pi * (2 - 3 * cosine + cosine * cosine * cosine);
  for (int axis = c.axisymmetric() ? 1 : 0; axis + 1 < c.dimension(); ++axis) {
    const double size = c.domain.size[axis], x = droplet.centre[axis];
    const bool on_side = x < 1e-9 * size || x > size * (1 - 1e-9);
    if (on_side && c.boundary.side[axis][0] != Side::periodic) whole /= 2;
  }
  return whole;
}

double volume_of_fluid(const Case& c) {
  double volume = c.domain.size.back() - c.wall_height();
  for (int axis = 0; axis + 1 < c.dimension(); ++axis) volume *= c.domain.size[axis];
  return c.axisymmetric() ? M_PI * c.domain.size[0] * volume : volume;
}

/// What the least radius of all droplets of a case depends on; it takes a while to find.
struct PhasesOfCase {
  double half_width, tension;
  Coexistence flat;
};

PhasesOfCase phases_of(const Case& c) {
  return {interface_half_width(*c.fluid), surface_tension(*c.fluid), coexistence(c.fluid->temperature)};
}

double least_radius_between(const PhasesOfCase& phases, const Case& c, const Droplet& droplet) {
  const Coexistence& flat = phases.flat;
  const double around = c.fluid->ambient == Phase::liquid ? flat.density_liquid : flat.density_vapour;
  const double jump = flat.density_liquid - flat.density_vapour, D = c.dimension_of_droplets();
  const double stiffness = VanDerWaals{c.fluid->temperature, 0}.curvature(around);
  const double sharp = std::pow(
      (D - 1) * phases.tension * volume_of_fluid(c) / (stiffness * jump * jump * growth(c, droplet)), 1 / (D + 1));
  return std::max(measured::least_radius * phases.half_width, sharp + measured::radius_of_flank * phases.half_width);
}

constexpr std::size_t most_told = 5;  ///< droplets that dissolve

void add_droplets(const Case& c, std::vector<std::string>& found) {
  if (c.droplets.empty() && c.films.empty() && c.waves.empty() && !c.gives_density())
    found.emplace_back(c.fluid->ambient == Phase::liquid
                           ? "the fluid holds liquid alone, at rest: add a [[droplet]] (softwet explain droplet)"
                           : "the fluid holds vapour alone, at rest: add a [[droplet]] or a [[film]] (softwet explain "
                             "droplet)");
  if (!c.fluid->initial.empty()) return;  // not the equilibrium the bound is about
  const PhasesOfCase phases = phases_of(c);
  std::size_t small = 0;
  for (std::size_t i = 0; i < c.droplets.size(); ++i) {
    const double radius = c.droplets[i].radius, least = least_radius_between(phases, c, c.droplets[i]);
    if (radius >= least || ++small > most_told) continue;
    found.push_back("droplet[" + std::to_string(i) + "].radius = " + short_text(radius) + " is below " +
                    short_text(least) + ", where a droplet of fluid.capillarity = " + short_text(c.fluid->capillarity) +
                    " dissolves in this domain: write a larger radius, or a smaller capillarity with more elements");
  }
  if (small > most_told)
    found.push_back(std::to_string(small - most_told) + " more of the " + std::to_string(c.droplets.size()) +
                    " droplets dissolve likewise");
}

void add_gaps(const Case& c, std::vector<std::string>& found) {
  const double bound = least_gap(*c.fluid);
  const std::vector<Gap> gaps = narrow_gaps(c, bound);
  if (gaps.empty()) return;
  const Gap& nearest = gaps.front();
  const std::string more =
      gaps.size() > 1 ? " (and " + std::to_string(gaps.size() - 1) + (gaps.size() < most_gaps ? " more)" : " or more)")
                      : "";
  found.push_back(
      nearest.one + " and " + nearest.other +
      (nearest.width > 0 ? " are " + short_text(nearest.width) + " apart" : std::string(" overlap")) + more +
      ": with less than " + short_text(bound) +
      " between them, four half widths of the interface, they may be one from the start or soon after; move "
      "them apart, or write a smaller fluid.capillarity than " +
      short_text(c.fluid->capillarity) + " with more elements");
}

/// Sampled soft solids with a tension bore their droplets with this material alone (docs/limits.md).
std::string material_that_bears(const Case& c) {
  if (c.substrate->material == MaterialModel::neo_hookean || c.substrate->surface_tension == 0) return "";
  return "write substrate.material = \"neo_hookean\"; or ";
}

/// A tenth of the Young modulus is what scenes were sampled with (docs/limits.md); a solid that has as much already
/// needs more.
std::string slowing_viscosity(const Case& c) {
  const double has = c.substrate->viscosity, sampled = 0.1 * c.substrate->young_modulus(), near = 0.99 * sampled;
  return "substrate.viscosity = " + short_text(has < near ? sampled : 3 * has) +
         (has > 0 ? " in place of " + short_text(has) : "") + ", which slows the first motion down";
}

/// Empty where the tension of the wall acts already, and where the case splits it by hand.
std::string tension_that_holds(const Case& c) {
  if (c.fluid->wall_tension == WallTensionModel::acts || c.has_wet_tension_by_hand()) return "";
  const std::string law = c.fluid->wall_law == WallLaw::energy ? "" : " and fluid.wall_law = \"energy\"";
  const std::string acts = "fluid.wall_tension = \"acts\"" + law;
  if (c.substrate->surface_tension > 0)
    return "write " + acts + ", with which the tension of the solid holds the ridge";
  return "give the solid the surface tension that it has (gels have one), for example substrate.surface_tension = " +
         short_text(surface_tension(*c.fluid)) + " as the liquid, with " + acts;
}

/// Below liquid: by hand, or as Young's law gives it.
double wet_tension(const Case& c) {
  if (c.fluid->wall_tension == WallTensionModel::none) return c.substrate->surface_tension_wet;
  return c.substrate->surface_tension - (1 - c.fluid->wall_stretch_exponent) * c.cosine_factor() *
                                            surface_tension(*c.fluid) *
                                            std::cos(c.fluid->contact_angle.least() * M_PI / 180);
}

bool has_neumann_triangle(const Case& c) {
  return c.substrate->surface_tension + wet_tension(c) > surface_tension(*c.fluid);
}

/// Whether the solid is of the kind whose sampled scenes bore more than others: its tension holds the ridge.
bool is_held_by_tension(const Case& c) {
  return c.substrate->material == MaterialModel::neo_hookean && c.substrate->surface_tension > 0 &&
         c.fluid->wall_tension == WallTensionModel::acts && has_neumann_triangle(c);
}

void add_softness(const Case& c, std::vector<std::string>& found) {
  const double length = elastocapillary_length(c), bound = longest_elastocapillary_length(c);
  if (is_held_by_tension(c) && length <= measured::held_by_neo_hookean * bound) return;
  if (length > measured::surely_held * bound && length <= bound)
    found.push_back(
        "substrate.young = " + short_text(c.substrate->young.least()) + ": the elastocapillary length sigma/E is " +
        short_text(length) + ", between " + short_text(measured::surely_held * bound) + " and " + short_text(bound) +
        ", where it depends on the scene whether the solid bears the droplet: some of those sampled at random "
        "folded at the contact line; if this one stops, " +
        gentle_start(c) + "; or write young = " +
        short_text(1.05 * c.substrate->young.least() * length / (measured::surely_held * bound)) + " or more");
  if (length <= bound) return;
  found.push_back("substrate.young = " + short_text(c.substrate->young.least()) +
                  ": the elastocapillary length sigma/E is " + short_text(length) +
                  " (thickness: " + short_text(c.substrate->thickness) +
                  ", fluid.capillarity: " + short_text(c.fluid->capillarity) + "); above " + short_text(bound) +
                  " the droplet was measured to turn the solid inside out soon after the start: " + gentle_start(c) +
                  "; or write young = " + short_text(1.05 * c.substrate->young.least() * length / bound) + " or more");
}

void add_neumann(const Case& c, std::vector<std::string>& found) {
  const double dry = c.substrate->surface_tension, sigma = surface_tension(*c.fluid);
  if (dry == 0 || has_neumann_triangle(c)) return;
  found.push_back("substrate.surface_tension = " + short_text(dry) + ": with " + short_text(wet_tension(c)) +
                  " below liquid the two are less than the surface tension " + short_text(sigma) +
                  " of the liquid, so that Neumann's triangle does not exist: the ridge is as sharp as the interface "
                  "is narrow; write more than " +
                  short_text(sigma - wet_tension(c)) + " for a ridge that does not depend on fluid.capillarity");
}

/// The Poisson ratio whose errors a solid has.
double locking_poisson(const Substrate& s) {
  return s.volume_quadrature == VolumeQuadrature::full ? s.poisson : std::min(s.poisson, SelectiveParts::poisson);
}

void add_locking(const Case& c, std::vector<std::string>& found) {
  constexpr double usual = 0.49;  // of a gel that counts as incompressible
  const double error = locking_error(c), of_ridge = ridge_error(c);
  const bool selective = c.substrate->volume_quadrature == VolumeQuadrature::selective;
  const std::string remedy = selective ? "" : "substrate.volume_quadrature = \"selective\", ";
  if (of_ridge >= std::max(measured::error_to_tell, error)) {
    Case finer = c;
    finer.domain.degree = 3;
    finer.substrate->volume_quadrature = VolumeQuadrature::full;
    const std::string at_degree_3 =
        c.domain.degree == 2 ? "degree = 3 (" + short_text(100 * ridge_error(finer)) + " %), " : "";
    found.push_back("substrate.poisson = " + short_text(c.substrate->poisson, 6) + " with domain.degree = " +
                    std::to_string(c.domain.degree) + " and " + short_text(c.fluid->capillarity / c.spacing()) +
                    " elements to fluid.capillarity: nearly incompressible, the solid locks at the contact line, where "
                    "its ridge is about " +
                    short_text(100 * of_ridge) + " % too low; write " + remedy + at_degree_3 +
                    (c.substrate->poisson > usual
                         ? "more elements, or poisson = 0.49, whose ridge is within 1.3 % of the one "
                           "at 0.4999"
                         : "more elements"));
    return;
  }
  if (error < measured::error_to_tell) return;
  found.push_back("substrate.poisson = " + short_text(c.substrate->poisson, 6) + " with domain.degree = 2 and " +
                  std::to_string(std::lround(c.rows_of_solid())) +
                  " rows of elements in the solid: nearly incompressible, it is about " + short_text(100 * error) +
                  " % too stiff (softwet verify locking); write " + remedy + "degree = 3 or take more elements");
}

void add_density(const Case& c, std::vector<std::string>& found) {
  const Substrate& s = *c.substrate;
  // A layer is about as dense as its liquid, whose density is near 1; softwet units writes such densities.
  if (s.density > 1 / measured::unusual_density && s.density < measured::unusual_density) return;
  found.push_back("substrate.density = " + short_text(s.density) + " multiplies substrate.young = " +
                  short_text(s.young.least()) + ": the Young modulus is " + short_text(s.young_modulus()) +
                  " a b^2; at a fixed young, another density is another stiffness (softwet explain substrate.young)");
}

void add_tolerance(const Case& c, std::vector<std::string>& found) {
  constexpr double loose = measured::loose_tolerance;
  if (!c.time.implicit() || c.solver.newton_atol <= loose) return;
  found.push_back(
      "solver.newton.atol = " + short_text(c.solver.newton_atol) + ": above " + short_text(loose) +
      " the errors that Newton's method leaves make the steps shorter, and a run takes more of them (six times as "
      "many at 1e-3): write " +
      short_text(SolverControl{}.newton_atol));
}

}  // namespace

double least_radius(const Case& c, const Droplet& droplet) { return least_radius_between(phases_of(c), c, droplet); }

double longest_elastocapillary_length(const Case& c) {
  const double without = std::max(measured::softness_of_interface * c.fluid->capillarity,
                                  measured::softness_of_droplet * largest_radius(c));
  const double face = stiffness_of_face(c, prestretch_of(c, stiffest_of(*c.substrate)));
  return std::clamp(face, 0.05, 1.0) * without *
         (1 + measured::softness_by_tension * c.substrate->surface_tension / surface_tension(*c.fluid));
}

bool too_soft(const Case& c) {
  return c.fluid && c.substrate && elastocapillary_length(c) > longest_elastocapillary_length(c);
}

std::string gentle_start(const Case& c) {
  const std::string viscous = slowing_viscosity(c), tension = tension_that_holds(c);
  if (c.time.start == StartState::equilibrium)
    return material_that_bears(c) + tension + (tension.empty() ? "" : "; or ") +
           "compute the motion in place of the state of rest, with " + viscous;
  return material_that_bears(c) + "write " + viscous + (tension.empty() ? "" : "; or ") + tension +
         "; or, which helps in few scenes, begin at rest with time.start = \"equilibrium\" or look for the state of "
         "rest "
         "alone with softwet steady";
}

double locking_error(const Case& c) {
  if (!c.substrate || c.domain.degree != 2) return 0;
  return measured::locking * std::pow(0.1 / (1 - 2 * locking_poisson(*c.substrate)), measured::locking_exponent) *
         std::pow(2 / c.rows_of_solid(), 2);
}

double ridge_error(const Case& c) {
  if (!c.fluid || !c.substrate || (c.droplets.empty() && c.films.empty() && !c.gives_density())) return 0;
  const double across = c.fluid->capillarity / c.spacing(), free = 1 - 2 * locking_poisson(*c.substrate);
  using namespace measured;
  const double of_rows = std::sqrt(8 / c.rows_of_solid());
  if (c.domain.degree == 2)
    return of_rows * ridge_degree_2 *
           std::exp(-ridge_degree_2_rate * std::sqrt(across * std::pow(free, ridge_degree_2_exponent)));
  return of_rows * ridge_degree_3 * std::exp(-ridge_degree_3_rate * across * std::pow(free, ridge_degree_3_exponent));
}

double least_gap(const Fluid& fluid) { return measured::least_gap * interface_half_width(fluid); }

std::vector<std::string> forecast(const Case& c) {
  std::vector<std::string> found;
  add_tolerance(c, found);
  if (c.fluid) add_droplets(c, found);
  if (c.fluid) add_gaps(c, found);
  if (!c.substrate) return found;
  if (c.fluid) add_softness(c, found);
  if (c.fluid) add_neumann(c, found);
  for (const std::string& told : forecast_of_prestretch(c)) found.push_back(told);
  add_locking(c, found);
  add_density(c, found);
  return found;
}

}  // namespace softwet
