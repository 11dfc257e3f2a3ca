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

/// A number, or a length.
void add_capillarity(CLI::App& command, PhysicalScene& scene) {
  const auto keep = [&scene](const std::string& text) {
    const Key& known = *find_key("fluid.capillarity");
    if (text.find_first_of("mM") != std::string::npos) {  // a length: all units of lengths have the letter
      scene.half_width = si_from_text("--capillarity", Quantity::length, text);
      return;
    }
    const auto number = number_from_text(text);
    if (!number || !known.range.contains(*number))
      reject("units", "--capillarity", text, "must be a " + allowed_text(known) + ", or a length",
             "write for example --capillarity 10um");
    scene.capillarity = *number;
  };
  command
      .add_option_function<std::string>(
          "--capillarity", keep,
          "half the width of the interface, a length or a number over L0; default: a tenth of the "
          "droplet's radius, with --case as the solid needs it")
      ->type_name("QUANTITY");
}

/// The droplet and its case file.
void add_case_options(CLI::App& command, WrittenCase& written) {
  CLI::Option* file =
      command.add_option("--case", written.path, "write a case file of this scene, with an axis of symmetry");
  file->type_name("FILE");
  command.add_flag("--2d", written.plane, "write it in 2D")->needs(file);
  const auto like = [&written](const std::string& word) {
    if (word != "paper")
      reject("units", "--like", word, "must be \"paper\"", "leave it out for a gel with a surface tension");
    written.of_paper = true;
  };
  command.add_option_function<std::string>("--like", like, "paper: its wall law, and a Saint Venant-Kirchhoff solid")
      ->type_name("WORD")
      ->needs(file);
}

}  // namespace

void add_units_command(CLI::App& app, PhysicalScene& scene, WrittenCase& written) {
  CLI::App& command = *app.add_subcommand("units", "turn physical numbers with their units into the numbers of a case");
  const auto add = [&](const std::string& name, Quantity quantity, double& place, const std::string& help) {
    return add_quantity(command, name, quantity, place, help);
  };
  CLI::Option_group& size = *command.add_option_group("size of the droplet");
  add_quantity(size, "--radius", Quantity::length, scene.radius, "radius of the droplet, for example 100um");
  const auto halve = [&scene](const std::string& text) {
    scene.radius = 0.5 * si_from_text("--diameter", Quantity::length, text);
  };
  size.add_option_function<std::string>("--diameter", halve, "its diameter, in place of the radius")
      ->type_name("QUANTITY");
  size.require_option(1);
  add("--surface-tension", Quantity::surface_tension, scene.surface_tension, "for example 72mN/m")->required();
  add("--density", Quantity::density, scene.density, "density of the liquid, for example 1000kg/m3")->required();
  add("--viscosity", Quantity::viscosity, scene.viscosity, "viscosity of the liquid, for example 1mPa.s")->required();
  add("--length", Quantity::length, scene.length,
      "L0, the length that is 1 in the case; default: radius / 0.15, with --case the radius");
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
  add_number(command, "--contact-angle", "fluid.contact_angle", scene.contact_angle,
             "contact angle in degrees; default: by Young's law from the tensions of the solid, else 90");
  add_capillarity(command, scene);
  add_case_options(command, written);
  command.footer(
      "Example: softwet units --radius 100um --surface-tension 72mN/m --density 1000kg/m3 --viscosity 10mPa.s\n"
      "             --young 3kPa --thickness 100um\n"
      "The density gives b, the surface tension gives a; the paper's scales follow (length L0, density b, stress a "
      "b^2).");
  for (const char* name : {"--solid-surface-tension", "--wet-surface-tension", "--solid-viscosity"})
    command.get_option(name)->needs("--young");
  command.get_option("--wet-surface-tension")->needs("--solid-surface-tension");
  command.callback([&scene, &written] { convert_units(scene, written, std::cout); });
}

}  // namespace softwet
