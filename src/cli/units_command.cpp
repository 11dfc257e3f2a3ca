// Options of `softwet units`.
#include "cli/units_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "casefile/schema/quantity.hpp"
#include "casefile/schema/schema.hpp"
#include "casefile/text/problems.hpp"
#include "cli/core/dispatch.hpp"

namespace softwet {
namespace {

CLI::Option* add_quantity(CLI::App& command, const std::string& name, Quantity quantity, double& place,
                          const std::string& help) {
  const auto keep = [&place, name, quantity](const std::string& text) { place = si_from_text(name, quantity, text); };
  return command.add_option_function<std::string>(name, keep, help)->type_name("QUANTITY");
}

/// A number that becomes a key of the case, in the range of that key.
void add_number(CLI::App& command, const std::string& name, const std::string& key, double& place,
                const std::string& help) {
  const auto keep = [&place, name, key](const std::string& text) {
    const Key& known = *find_key(key);
    const auto number = number_from_text(text);
    if (!number || !known.range.contains(*number))
      reject("units", name, text, "must be a " + allowed_text(known),
             fmt::format("write for example {} {}", name, example_text(known)));
    place = *number;
  };
  command.add_option_function<std::string>(name, keep, help)->type_name("NUMBER");
}

}  // namespace

void add_units_command(CLI::App& app, PhysicalScene& scene) {
  CLI::App& command = *app.add_subcommand("units", "turn physical numbers with their units into the numbers of a case");
  const auto add = [&](const std::string& name, Quantity quantity, double& place, const std::string& help) {
    return add_quantity(command, name, quantity, place, help);
  };
  add("--radius", Quantity::length, scene.radius, "radius of the droplet, for example 100um")->required();
  add("--surface-tension", Quantity::surface_tension, scene.surface_tension, "for example 72mN/m")->required();
  add("--density", Quantity::density, scene.density, "density of the liquid, for example 1000kg/m3")->required();
  add("--viscosity", Quantity::viscosity, scene.viscosity, "viscosity of the liquid, for example 1mPa.s")->required();
  add("--length", Quantity::length, scene.length, "L0, the length that is 1 in the case; default: radius / 0.15");
  add("--young", Quantity::stress, scene.young, "Young modulus of the layer, for example 3kPa; default: no solid");
  add("--thickness", Quantity::length, scene.thickness, "thickness of the layer; default: the radius");
  add("--solid-density", Quantity::density, scene.solid_density, "density of the layer; default: the liquid's");
  add("--solid-surface-tension", Quantity::surface_tension, scene.solid_tension,
      "surface tension of the dry layer, for example 31mN/m; default: none");
  add("--wet-surface-tension", Quantity::surface_tension, scene.wet_tension,
      "surface tension of the layer below the liquid; default: the dry layer's");
  add("--solid-viscosity", Quantity::viscosity, scene.solid_viscosity,
      "shear viscosity of the layer, for example 20Pa.s; default: none");
  add_number(command, "--poisson", "substrate.poisson", scene.poisson, "Poisson ratio of the layer; default: 0.45");
  add_number(command, "--temperature", "fluid.temperature", scene.temperature,
             "temperature of the model fluid over its critical one; default: 0.39, a vapour of 1/641 of the density");
  add_number(command, "--capillarity", "fluid.capillarity", scene.capillarity,
             "fluid.capillarity, half the width of the interface over L0; default: a tenth of the droplet's radius");
  command.footer(
      "Example: softwet units --radius 100um --surface-tension 72mN/m --density 1000kg/m3 --viscosity 10mPa.s\n"
      "             --young 3kPa --thickness 100um\n"
      "The density gives b, the surface tension gives a; the paper's scales follow (length L0, density b, stress a "
      "b^2).");
  for (const char* name : {"--solid-surface-tension", "--wet-surface-tension", "--solid-viscosity"})
    command.get_option(name)->needs("--young");
  command.get_option("--wet-surface-tension")->needs("--solid-surface-tension");
  command.callback([&scene] { convert_units(scene, std::cout); });
}

}  // namespace softwet
