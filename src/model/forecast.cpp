#include "model/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "case/cap.hpp"
#include "model/equilibrium.hpp"
#include "model/groups.hpp"

namespace softwet {
namespace {

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// (dV/dR) / R^(D-1) of a droplet: of a disc 2 pi, of a ball 4 pi, less for a cap and for a half on a slip side.
double growth(const Case& c, const Droplet& droplet) {
  const double pi = std::acos(-1.0), cosine = sits_on_wall(c, droplet) ? cap_cosine(*c.fluid) : -1;
  const double angle = std::acos(cosine);
  double whole =
      c.dimension() == 2 ? 2 * (angle - std::sin(angle) * cosine) : pi * (2 - 3 * cosine + cosine * cosine * cosine);
  for (int axis = 0; axis + 1 < c.dimension(); ++axis) {
    const double size = c.domain.size[axis], x = droplet.centre[axis];
    const bool on_side = x < 1e-9 * size || x > size * (1 - 1e-9);
    if (on_side && c.boundary.side[axis][0] != Side::periodic) whole /= 2;
  }
  return whole;
}

double volume_of_fluid(const Case& c) {
  double volume = c.domain.size.back() - (c.substrate ? c.substrate->thickness : 0);
  for (int axis = 0; axis + 1 < c.dimension(); ++axis) volume *= c.domain.size[axis];
  return volume;
}

void add_droplets(const Case& c, std::vector<std::string>& found) {
  if (c.droplets.empty() && c.films.empty() && c.waves.empty())
    found.push_back(std::string("the fluid holds ") + (c.fluid->ambient == Phase::liquid ? "liquid" : "vapour") +
                    " alone, at rest: add a [[droplet]] or a [[film]] (softwet explain droplet)");
  if (!c.fluid->initial.empty()) return;  // not the equilibrium the bound is about
  for (std::size_t i = 0; i < c.droplets.size(); ++i) {
    const double radius = c.droplets[i].radius, least = least_radius(c, c.droplets[i]);
    if (radius >= least) continue;
    found.push_back("droplet[" + std::to_string(i) + "].radius = " + short_text(radius) + " is below " +
                    short_text(least) + ", where a droplet of fluid.capillarity = " + short_text(c.fluid->capillarity) +
                    " dissolves in this domain: write a larger radius, or a smaller capillarity with more elements");
  }
}

void add_softness(const Case& c, std::vector<std::string>& found) {
  if (!too_soft(c)) return;
  const double length = elastocapillary_length(c), bound = longest_elastocapillary_length(c);
  found.push_back("substrate.young = " + short_text(c.substrate->young) + ": the elastocapillary length sigma/E is " +
                  short_text(length) + " (thickness: " + short_text(c.substrate->thickness) +
                  ", fluid.capillarity: " + short_text(c.fluid->capillarity) + "); above " + short_text(bound) +
                  " the droplet was measured to turn the solid inside out soon after the start: write young = " +
                  short_text(1.05 * c.substrate->young * length / bound) + " or more");
}

void add_locking(const Case& c, std::vector<std::string>& found) {
  const double error = locking_error(c);
  if (error < 0.01) return;
  found.push_back("substrate.poisson = " + short_text(c.substrate->poisson) + " with domain.degree = 2 and " +
                  std::to_string(std::lround(c.rows_of_solid())) +
                  " rows of elements in the solid: nearly incompressible, it is about " + short_text(100 * error) +
                  " % too stiff (softwet verify locking); write degree = 3 or take more elements");
}

void add_density(const Case& c, std::vector<std::string>& found) {
  const Substrate& s = *c.substrate;
  if (s.density == 1) return;
  found.push_back("substrate.density = " + short_text(s.density) + " multiplies substrate.young = " +
                  short_text(s.young) + ": the Young modulus is " + short_text(s.young_modulus()) +
                  " a b^2; at a fixed young, another density is another stiffness (softwet explain substrate.young)");
}

void add_tolerance(const Case& c, std::vector<std::string>& found) {
  constexpr double loose = 1e-5;
  if (c.time.scheme != implicit_scheme || c.solver.newton_atol <= loose) return;
  found.push_back(
      "solver.newton.atol = " + short_text(c.solver.newton_atol) + ": above " + short_text(loose) +
      " the errors that Newton's method leaves make the steps shorter, and a run takes more of them (six times as "
      "many at 1e-3): write " +
      short_text(SolverControl{}.newton_atol));
}

}  // namespace

double least_radius(const Case& c, const Droplet& droplet) {
  const double width = interface_half_width(*c.fluid), tension = surface_tension(*c.fluid);
  const Coexistence flat = coexistence(c.fluid->temperature);
  const double around = c.fluid->ambient == Phase::liquid ? flat.density_liquid : flat.density_vapour;
  const double jump = flat.density_liquid - flat.density_vapour, D = c.dimension();
  const double stiffness = VanDerWaals{c.fluid->temperature, 0}.curvature(around);
  const double sharp =
      std::pow((D - 1) * tension * volume_of_fluid(c) / (stiffness * jump * jump * growth(c, droplet)), 1 / (D + 1));
  return std::max(1.75 * width, sharp + 0.5 * width);
}

double longest_elastocapillary_length(const Case& c) {
  return std::max(0.85 * c.fluid->capillarity, 0.17 * largest_radius(c));
}

bool too_soft(const Case& c) {
  return c.fluid && c.substrate && elastocapillary_length(c) > longest_elastocapillary_length(c);
}

double locking_error(const Case& c) {
  if (!c.substrate || c.domain.degree != 2) return 0;
  return 0.0094 * std::pow(0.1 / (1 - 2 * c.substrate->poisson), 0.37) * std::pow(2 / c.rows_of_solid(), 2);
}

std::vector<std::string> forecast(const Case& c) {
  std::vector<std::string> found;
  add_tolerance(c, found);
  if (c.fluid) add_droplets(c, found);
  if (!c.substrate) return found;
  if (c.fluid) add_softness(c, found);
  add_locking(c, found);
  add_density(c, found);
  return found;
}

}  // namespace softwet
