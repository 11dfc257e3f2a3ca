#include "scene/groups.hpp"

#include <algorithm>
#include <cmath>

#include "case/cap.hpp"
#include "case/gel.hpp"
#include "scene/equilibrium.hpp"

namespace softwet {
namespace {

// docs/verification/speed_ripple.md: on a soft layer, with two elements to the capillarity; from there to three it
// falls with the fourth power.
constexpr double ripple_of_two_elements = 0.013, ripple_to_tell = 0.001;

bool acts_along(const std::vector<double>& vector) { return !vector.empty() && vector[0] != 0; }

/// A droplet on the wall that no side cuts.
bool has_droplet_on_wall(const Case& c) {
  return std::any_of(c.droplets.begin(), c.droplets.end(), [&](const Droplet& droplet) {
    const double side = 1e-9 * c.domain.size[0], x = droplet.centre[0];
    return sits_on_wall(c, droplet) && x > side && x < c.domain.size[0] - side;
  });
}

/// Whether something acts on droplets along the wall.
bool is_driven_along_wall(const Case& c) {
  if (!c.loads.empty() || c.fluid->contact_angle.varies() || acts_along(c.fluid->gravity)) return true;
  if (std::any_of(c.needles.begin(), c.needles.end(), [](const Needle& n) { return !n.path.empty(); })) return true;
  if (std::any_of(c.droplets.begin(), c.droplets.end(), [](const Droplet& d) { return acts_along(d.velocity); }))
    return true;
  return c.substrate &&
         (c.substrate->young.varies() || c.substrate->fibre.stiffness > 0 || acts_along(c.substrate->gravity));
}

}  // namespace

double speed_ripple(const Case& c) {
  if (c.dimension() != 2 || c.axisymmetric() || c.domain.degree != 2 || !c.fluid) return 0;
  if (!has_droplet_on_wall(c) || !is_driven_along_wall(c)) return 0;
  const double across = c.fluid->capillarity * c.domain.elements[0] / c.domain.size[0];
  return ripple_of_two_elements * std::pow(2 / std::max(across, 1.0), 4);
}

double Liquid::ohnesorge() const { return viscosity / std::sqrt(density * tension * radius); }

double Liquid::time_inertia() const { return std::sqrt(density * radius * radius * radius / tension); }

double largest_radius(const Case& c) {
  double largest = 0;
  for (const Droplet& droplet : c.droplets) largest = std::max(largest, droplet.radius);
  return largest;
}

Liquid liquid_of(const Case& c) {
  return {coexistence(c.fluid->temperature).density_liquid, c.fluid->viscosity, surface_tension(*c.fluid),
          largest_radius(c)};
}

double elastocapillary_length(const Case& c) {
  return c.fluid && c.substrate ? surface_tension(*c.fluid) / c.substrate->young_modulus() : 0;
}

double time_elasticity(const Substrate& s) { return s.thickness / std::sqrt(s.shear_modulus() / s.density); }

std::vector<Group> groups(const Case& c) {
  std::vector<Group> all;
  const double radius = largest_radius(c), length = elastocapillary_length(c);
  if (length > 0) {
    if (radius > 0) all.push_back({"elastocapillary_over_radius", length / radius, "sigma / (E R)"});
    all.push_back({"elastocapillary_over_thickness", length / c.substrate->thickness, "sigma / (E Hs)"});
    all.push_back({"elastocapillary_over_interface", length / (2 * c.fluid->capillarity),
                   "sigma / (E 2 gamma), 2 gamma being the width of the interface"});
  }
  if (c.fluid && c.substrate && c.substrate->surface_tension > 0) {
    const double tension = c.substrate->surface_tension;
    all.push_back({"solid_tension_over_sigma", tension / surface_tension(*c.fluid),
                   "Upsilon / sigma: surface tension of the dry solid over the liquid's"});
    all.push_back({"solid_tension_over_interface", tension / (c.substrate->young_modulus() * 2 * c.fluid->capillarity),
                   "Upsilon / (E 2 gamma): above 1 tension holds the ridge, below elasticity does"});
  }
  if (c.substrate && c.substrate->modulus_of_surface() > 0)
    all.push_back({"surface_modulus_over_thickness",
                   c.substrate->modulus_of_surface() / (c.substrate->young_modulus() * c.substrate->thickness),
                   "(lambda_s + 2 G_s) / (E Hs): modulus of the solid's surface over the layer's"});
  const auto add = [&](const char* name, double value, const char* meaning) { all.push_back({name, value, meaning}); };
  if (c.substrate) c.parts.each([&](const auto& part) { part.add_groups(*c.substrate, add); });
  if (c.fluid && radius > 0) {
    const Liquid liquid = liquid_of(c);
    all.push_back({"radius_over_capillarity", radius / c.fluid->capillarity, "R / gamma"});
    all.push_back({"ohnesorge", liquid.ohnesorge(), "mu / sqrt(rho_l sigma R)"});
    all.push_back(
        {"capillary_number", liquid.capillary_number(1), "mu v / sigma at v = 1; times a speed of history.csv"});
    all.push_back({"reynolds", liquid.reynolds(1), "rho_l v R / mu at v = 1; times a speed of history.csv"});
    all.push_back({"time_capillary", liquid.time_capillary(), "mu R / sigma: capillarity against viscosity"});
    all.push_back({"time_inertia", liquid.time_inertia(), "sqrt(rho_l R^3 / sigma): capillarity against inertia"});
    all.push_back({"time_viscosity", liquid.time_viscosity(), "rho_l R^2 / mu: viscosity against inertia"});
  }
  if (const double ripple = speed_ripple(c); ripple >= ripple_to_tell)
    all.push_back({"speed_ripple", ripple,
                   "what the mesh adds to the speed of a droplet, rms over it, with the period of an element; 1.2 "
                   "times as many elements along each axis halve it"});
  if (c.substrate)
    all.push_back(
        {"time_elasticity", time_elasticity(*c.substrate), "Hs / sqrt(G / rho_0^s): a shear wave in the layer"});
  if (c.substrate && shear_viscosity(*c.substrate) > 0)
    all.push_back({"time_creep", shear_viscosity(*c.substrate) / c.substrate->shear_modulus(),
                   "eta / G: the solid's viscosity against its elasticity"});
  return all;
}

}  // namespace softwet
