#include "cli/core/scales.hpp"

#include <algorithm>
#include <cmath>

#include "scene/equilibrium.hpp"

namespace softwet {
namespace {

constexpr double usual_radius = 0.15;  ///< of a droplet in a domain of length 1

double length_of(const PhysicalScene& p) { return p.length > 0 ? p.length : p.radius / usual_radius; }

}  // namespace

double capillarity_of(const PhysicalScene& p) {
  if (p.capillarity > 0) return p.capillarity;
  return (p.half_width > 0 ? p.half_width : 0.1 * p.radius) / length_of(p);
}

double contact_angle_of(const PhysicalScene& p) {
  if (p.contact_angle > 0) return p.contact_angle;
  if (p.wet_tension < 0) return 90;
  return std::acos(std::clamp((p.solid_tension - p.wet_tension) / p.surface_tension, -1.0, 1.0)) * 180 / M_PI;
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

Case case_of_laboratory(const PhysicalScene& p) {
  PhysicalScene whole = p;
  if (whole.young <= 0) whole.young = 1;  // a solid without a modulus of its own
  return case_of(whole, scales_of(whole));
}

}  // namespace softwet
