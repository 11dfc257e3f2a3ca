#include "scene/groups.hpp"

#include <algorithm>
#include <cmath>

#include "case/gel.hpp"
#include "scene/equilibrium.hpp"

namespace softwet {

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
  if (c.substrate && !c.boundary.foundation.empty())
    all.push_back({"foundation_over_layer",
                   c.boundary.foundation[0] * c.substrate->thickness * (1 - 2 * c.substrate->poisson) /
                       (2 * c.substrate->shear_modulus() * (1 - c.substrate->poisson)),
                   "kap_n Hs / (lambda + 2 G): springs below the layer over its own stiffness"});
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
  if (c.substrate)
    all.push_back(
        {"time_elasticity", time_elasticity(*c.substrate), "Hs / sqrt(G / rho_0^s): a shear wave in the layer"});
  if (c.substrate && shear_viscosity(*c.substrate) > 0)
    all.push_back({"time_creep", shear_viscosity(*c.substrate) / c.substrate->shear_modulus(),
                   "eta / G: the solid's viscosity against its elasticity"});
  return all;
}

}  // namespace softwet
