#include "cli/core/units.hpp"

#include <cmath>

#include "case/text.hpp"
#include "casefile/schema/schema.hpp"
#include "cli/core/describe.hpp"
#include "cli/core/scales.hpp"
#include "observe/host/laboratory_units.hpp"
#include "scene/equilibrium.hpp"
#include "scene/groups.hpp"

namespace softwet {
namespace {

std::string with_unit(double value, const char* unit = "") { return short_text(value, 4) + (*unit ? " " : "") + unit; }

/// Seven digits, more than anybody measures.
std::string key(const std::string& name, double value) {
  return name + " = " + text_of_number(*number_from_text(short_text(value, 7))) + "\n";
}

/// The line of a number that a solid may have.
std::string if_any(const std::string& name, double value) { return value == 0 ? "" : key(name, value); }

void print_scales(const Scales& s, std::ostream& out) {
  print_section(out, "one unit of a case is",
                {{"length L0", with_unit(s.length, "m")},
                 {"time L0/sqrt(ab)", with_unit(s.time(), "s")},
                 {"velocity sqrt(ab)", with_unit(s.velocity(), "m/s")},
                 {"density b", with_unit(s.density, "kg/m^3")},
                 {"stress a b^2", with_unit(s.stress(), "Pa")},
                 {"surface tension a b^2 L0", with_unit(s.stress() * s.length, "N/m")},
                 {"viscosity L0 b sqrt(ab)", with_unit(s.viscosity(), "Pa s")},
                 {"load[].force ab/L0", with_unit(s.velocity() * s.velocity() / s.length, "m/s^2")}});
}

/// A liquid in the numbers of the case against the same liquid in SI units: the groups agree.
void print_groups(const PhysicalScene& p, const Case& c, const Scales& s, std::ostream& out) {
  const Liquid real{p.density, p.viscosity, p.surface_tension, p.radius};
  std::vector<Line> lines{{"", "physical    in the case"}};
  const auto both = [&](const std::string& name, double physical, double scaled) {
    std::string first = with_unit(physical);
    first.resize(std::max<std::size_t>(first.size(), 11), ' ');
    lines.push_back({name, first + " " + with_unit(scaled)});
  };
  const Liquid model = liquid_of(c);
  both("Ohnesorge number", real.ohnesorge(), model.ohnesorge());
  if (c.substrate) {
    const double length = p.surface_tension / p.young, thickness = c.substrate->thickness * s.length;
    both("sigma / (E R)", length / p.radius, elastocapillary_length(c) / model.radius);
    if (p.solid_tension > 0)
      both("sigma / tension of the dry solid", p.surface_tension / p.solid_tension,
           surface_tension(*c.fluid) / c.substrate->surface_tension);
    both("sigma / (E Hs)", length / thickness, elastocapillary_length(c) / c.substrate->thickness);
  }
  print_section(out, "groups", lines);
}

void print_limits(const Case& c, const Scales& s, std::ostream& out) {
  const Coexistence flat = coexistence(c.fluid->temperature);
  const double curvature = VanDerWaals{c.fluid->temperature, 0}.curvature(flat.density_liquid);
  const double sound = s.velocity() * std::sqrt(flat.density_liquid * curvature);
  print_section(
      out, "what the model cannot reach",
      {{"width of the interface", with_unit(2 * c.fluid->capillarity * s.length, "m") +
                                      "; a real one is some nanometres wide, keep this far below the radius"},
       {"speed of sound in the liquid",
        with_unit(sound, "m/s") + "; of water 1480 m/s, keep all speeds far below the model's"},
       {"density of the vapour", with_unit(flat.density_vapour * s.density, "kg/m^3") + "; 1/" +
                                     with_unit(flat.density_liquid / flat.density_vapour) +
                                     " of the liquid's, with the same viscosity"},
       {"evaporation", "the vapour condenses and evaporates: small droplets dissolve, softwet check says where"}});
}

void print_keys(const Case& c, std::ostream& out) {
  out << "\n# lines for a case file; two elements or more for a capillarity: domain.elements of "
      << std::ceil(2 / c.fluid->capillarity) << " along a length of 1\n[fluid]\n"
      << key("viscosity", c.fluid->viscosity) << key("capillarity", c.fluid->capillarity)
      << key("temperature", c.fluid->temperature);
  if (c.substrate)
    out << "\n[substrate]\n"
        << key("thickness", c.substrate->thickness) << key("density", c.substrate->density)
        << key("young", c.substrate->young.number) << key("poisson", c.substrate->poisson)
        << if_any("surface_tension", c.substrate->surface_tension)
        << if_any("surface_tension_wet", c.substrate->surface_tension_wet != c.substrate->surface_tension
                                             ? c.substrate->surface_tension_wet
                                             : 0)
        << if_any("viscosity", c.substrate->viscosity);
  out << "\n[[droplet]]\n" << key("radius", c.droplets.front().radius);
}

/// "100 um" and "[1150, 1150] um"; empty for what is no number.
std::string in_unit(const Value& value, const ShownUnit& unit) {
  if (const auto* number = std::get_if<double>(&value)) return with_unit(*number * unit.factor, unit.name.c_str());
  const auto* numbers = std::get_if<Numbers>(&value);
  if (!numbers || numbers->empty()) return {};
  std::string text;
  for (const double number : *numbers) text += (text.empty() ? "[" : ", ") + short_text(number * unit.factor, 4);
  return text + "]" + (unit.name.empty() ? "" : " " + unit.name);
}

}  // namespace

void describe_laboratory(const Scales& scales, const Case& c, std::ostream& out) {
  print_scales(scales, out);
  std::vector<Line> lines;
  for (const Key& key : schema()) {
    const Table* table = find_table(key.table());
    const auto unit = shown_unit(key.unit, dimension_of_units(c), scales);
    for (std::size_t i = 0; unit && table && i < table->count(c); ++i) {
      const Value value = key.bind.get(c, i);
      const std::string shown = in_unit(value, *unit);
      if (!shown.empty() && text_of_value(value) != default_text(key))
        lines.push_back({indexed_name(key.name, i), in_unit(value, {"", 1}) + " is " + shown});
    }
  }
  if (c.substrate)
    lines.push_back({"substrate.density x young",
                     with_unit(c.substrate->young_modulus()) + " is " +
                         in_unit(c.substrate->young_modulus(), *shown_unit("a b^2", dimension_of_units(c), scales))});
  print_section(out, "in the laboratory", lines);
}

void describe_units(const PhysicalScene& p, std::ostream& out) {
  const Scales scales = scales_of(p);
  const Case c = case_of(p, scales);
  print_scales(scales, out);
  print_groups(p, c, scales, out);
  print_limits(c, scales, out);
  print_keys(c, out);
}

}  // namespace softwet
