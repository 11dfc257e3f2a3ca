#include "cli/core/units_case.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/case_file.hpp"
#include "cli/core/scales.hpp"
#include "foresight/width.hpp"
#include "io/atomic_file.hpp"

namespace softwet {
namespace {

// Half widths of the interface to the radius of a droplet: the most, for the size of the mesh, and the fewest.
constexpr double most_half_widths = 100, least_half_widths = 10;
constexpr double longest_element = 16, nearly_incompressible = 0.45;
/// Thicknesses between the contact line and the side, which moves a ridge by 0.4 % at three.
constexpr double layers_beside = 6;
constexpr int rows_together = 4;  ///< so that wider interfaces have meshes with an end of elements on the wall too

/// The scene of the file: lengths in L0, the mesh, and the time to compute.
struct LabScene {
  PhysicalScene scene;  ///< with the half width
  double angle, radius, thickness, element;
  int across, upwards;
  double end;
};

/// fluid.capillarity: as asked for, else as wide as softwet check accepts it.
double half_width_of(const PhysicalScene& p) {
  if (p.capillarity > 0 || p.half_width > 0) return capillarity_of(p);
  const Case c = case_of(p, scales_of(p));
  const double radius = p.radius / p.length, most = radius / least_half_widths, least = radius / most_half_widths;
  return c.substrate ? std::clamp(0.5 * widest_interface(c), least, most) : most;
}

int in_fours(double count) { return rows_together * static_cast<int>(std::ceil(count / rows_together - 1e-9)); }

LabScene lab_scene_of(PhysicalScene p) {
  if (p.length == 0) p.length = p.radius;
  if (p.young > 0 && p.thickness == 0) p.thickness = p.radius;
  LabScene all{p, contact_angle_of(p), p.radius / p.length, p.young > 0 ? p.thickness / p.length : 0, 0, 0, 0, 0};
  const double half_width = half_width_of(p);
  // Two elements to the half width, and a whole number of them in the layer.
  const double rows = all.thickness > 0 ? all.thickness : all.radius;
  all.element = rows / in_fours(2 * rows / half_width);
  all.scene.capillarity = 0;
  all.scene.half_width = 2 * all.element * p.length;
  const double cosine = std::cos(all.angle * M_PI / 180);
  const double foot = all.angle < 90 ? all.radius * std::sin(all.angle * M_PI / 180) : all.radius;
  const double height = all.radius * (1 - cosine);
  all.across = in_fours((foot + std::max(foot, layers_beside * all.thickness) + 4 * half_width) / all.element);
  all.upwards = in_fours((all.thickness + 2 * height + 4 * half_width) / all.element);
  const Scales scales = scales_of(all.scene);
  const double inertia = std::sqrt(p.density * std::pow(p.radius, 3) / p.surface_tension);
  const double viscosity =
      std::max(p.viscosity * p.radius / p.surface_tension, p.young > 0 ? 3 * p.solid_viscosity / p.young : 0);
  all.end = 20 * std::max(inertia, viscosity) / scales.time();
  return all;
}

void refuse_contradiction(const PhysicalScene& p, const WrittenCase& file) {
  if (file.of_paper || p.wet_tension < 0) return;
  const double cosine = (p.solid_tension - p.wet_tension) / p.surface_tension;
  if (std::abs(cosine) >= 1)
    throw Error(Exit::invalid_input,
                "units: the dry and the wet tension of the solid differ by more than the liquid's tension, " +
                    short_text(std::abs(cosine), 4) + " times: no contact line stands there; give others");
  constexpr double tolerance = 0.01;
  if (p.contact_angle > 0 && std::abs(std::cos(p.contact_angle * M_PI / 180) - cosine) > tolerance)
    throw Error(Exit::invalid_input, "units: --contact-angle " + short_text(p.contact_angle, 5) +
                                         " contradicts Young's law, by which the tensions of the solid give " +
                                         short_text(std::acos(cosine) * 180 / M_PI, 5) +
                                         " degrees; leave --contact-angle or --wet-surface-tension out");
}

/// A line of the table [laboratory]; nothing where the scene has no such quantity.
std::string quantity(const char* name, double value, double unit, const char* of, const char* about = "") {
  if (value <= 0) return "";
  constexpr std::size_t comments = 38;  // the column where they begin
  std::string line = std::string(name) + " = \"" + short_text(value / unit, 10) + " " + of + "\"";
  if (*about) line.resize(std::max(comments, line.size()), ' ');
  return *about ? line + " # " + about + "\n" : line + "\n";
}

std::string laboratory_table(const LabScene& all, const WrittenCase& file) {
  const PhysicalScene& p = all.scene;
  constexpr double um = 1e-6, milli = 1e-3, kilo = 1e3;
  std::string text =
      "\n[laboratory]                           # the other tables are in units that follow from these\n" +
      quantity("length", p.length, um, "um", "L0, a length of 1 in the other tables") +
      quantity("surface_tension", p.surface_tension, milli, "mN/m", "of the liquid") +
      quantity("density", p.density, 1, "kg/m3") + quantity("viscosity", p.viscosity, milli, "mPa.s") +
      quantity("capillarity", p.half_width, um, "um", "half the width of the interface") +
      quantity("radius", p.radius, um, "um", "of the droplet's circle");
  if (p.young <= 0) return text;
  text += quantity("thickness", p.thickness, um, "um", "of the layer") + quantity("young", p.young, kilo, "kPa") +
          quantity("solid_density", p.solid_density, 1, "kg/m3") +
          quantity("solid_surface_tension", p.solid_tension, milli, "mN/m", "dry");
  if (file.of_paper) text += quantity("wet_surface_tension", p.wet_tension, milli, "mN/m", "below liquid");
  return text + quantity("solid_viscosity", p.solid_viscosity, 1, "Pa.s");
}

std::string domain_table(const LabScene& all, const WrittenCase& file) {
  const char* axis = file.plane ? "" : "coordinates = \"axisymmetric\"           # the left side is the axis\n";
  return std::string("\n[domain]\n") + axis + "size = [" + short_text(all.across * all.element, 10) + ", " +
         short_text(all.upwards * all.element, 10) + "]\nelements = [" + std::to_string(all.across) + ", " +
         std::to_string(all.upwards) +
         "]\ngrading = { fine = \"automatic\", coarsest = " + short_text(longest_element) + " }\n";
}

std::string fluid_table(const LabScene& all, const WrittenCase& file) {
  const PhysicalScene& p = all.scene;
  std::string text = "\n[fluid]\ntemperature = " + short_text(p.temperature, 7) +
                     "\ncontact_angle = " + short_text(all.angle, 7) + "\n";
  if (file.of_paper) return text;
  text += "wall_law = \"energy\"\n";
  if (p.solid_tension > 0)
    text += "wall_tension = \"acts\"                  # Young's law gives the tension of the wet solid\n";
  return text;
}

std::string solid_table(const LabScene& all, const WrittenCase& file) {
  const PhysicalScene& p = all.scene;
  if (p.young <= 0) return "";
  std::string text = "\n[substrate]\npoisson = " + short_text(p.poisson, 7) + "\n";
  if (!file.of_paper) text += "material = \"neo_hookean\"\n";
  if (p.poisson > nearly_incompressible)
    text += "volume_quadrature = \"selective\"        # a nearly incompressible layer would lock\n";
  return text;
}

std::string text_of_lab_scene(const LabScene& all, const WrittenCase& file, const std::string& name) {
  const std::string end = short_text(all.end, 4);
  return "# A droplet on a layer, written by softwet units. 'softwet steady' finds its state of rest, 'softwet "
         "converge' what it is\n# with an interface of zero width.\n"
         "name = \"" +
         name + "\"\n" + laboratory_table(all, file) + domain_table(all, file) + fluid_table(all, file) +
         solid_table(all, file) + "\n[[droplet]]\ncentre = [0.0, " + short_text(all.thickness, 10) + "]\n" +
         "\n[boundary]\nbottom = \"clamped\"                     # glass\n" + "\n[time]\nend = " + end +
         "\n\n[output]\nfields = { times = [0.0, " + end + "] }\n";
}

}  // namespace

PhysicalScene water_on_gel() {
  PhysicalScene p;
  p.radius = 500e-6;
  p.surface_tension = 72e-3;
  p.density = 1000;
  p.viscosity = 1e-3;
  p.young = 3000;
  p.thickness = 100e-6;
  p.poisson = 0.49;
  p.solid_tension = 50e-3;
  return p;
}

std::string units_case(const PhysicalScene& p, const WrittenCase& file, const std::string& name) {
  refuse_contradiction(p, file);
  initial_case(name);  // refuses what cannot be the name of a case
  return text_of_lab_scene(lab_scene_of(p), file, name);
}

void write_units_case(const PhysicalScene& p, const WrittenCase& file, std::ostream& out) {
  if (std::filesystem::exists(file.path))
    throw Error(Exit::invalid_input, "units: '" + file.path + "' exists and stays as it is; give another name");
  write_text_atomically(file.path, units_case(p, file, std::filesystem::path(file.path).stem().string()));
  out << "wrote " << file.path << "; next: softwet check " << file.path << ", softwet steady " << file.path
      << ", softwet converge " << file.path << "\n";
}

}  // namespace softwet
