#include "cli/core/scales.hpp"

#include <cmath>

#include "scene/equilibrium.hpp"

namespace softwet {
namespace {

constexpr double usual_radius = 0.15;  ///< of a droplet in a domain of length 1

double length_of(const PhysicalScene& p) { return p.length > 0 ? p.length : p.radius / usual_radius; }

}  // namespace

double Scales::velocity() const { return std::sqrt(a * density); }

double capillarity_of(const PhysicalScene& p) {
  return p.capillarity > 0 ? p.capillarity : 0.1 * p.radius / length_of(p);
}

Scales scales_of(const PhysicalScene& p) {
  Fluid fluid;
  fluid.temperature = p.temperature;
  fluid.capillarity = capillarity_of(p);
  const double length = length_of(p), b = p.density / coexistence(p.temperature).density_liquid;
  return {length, b, p.surface_tension / (surface_tension(fluid) * b * b * length)};
}

Case case_of(const PhysicalScene& p, const Scales& scales) {
  Case c;
  c.fluid.emplace();
  c.fluid->viscosity = p.viscosity / scales.viscosity();
  c.fluid->capillarity = capillarity_of(p);
  c.fluid->temperature = p.temperature;
  c.droplets.push_back({{}, p.radius / scales.length});
  if (p.young <= 0) return c;
  c.substrate.emplace();
  c.substrate->thickness = (p.thickness > 0 ? p.thickness : p.radius) / scales.length;
  c.substrate->density = (p.solid_density > 0 ? p.solid_density : p.density) / scales.density;
  c.substrate->young = p.young / (scales.stress() * c.substrate->density);
  c.substrate->poisson = p.poisson;
  const double tension = scales.stress() * scales.length;
  c.substrate->surface_tension = p.solid_tension / tension;
  c.substrate->surface_tension_wet = (p.wet_tension >= 0 ? p.wet_tension : p.solid_tension) / tension;
  c.substrate->viscosity = p.solid_viscosity / scales.viscosity();
  return c;
}

}  // namespace softwet
