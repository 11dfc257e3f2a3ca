#include "foresight/width.hpp"

#include <algorithm>

#include "case/cap.hpp"
#include "case/text.hpp"
#include "scene/groups.hpp"

namespace softwet {
namespace {

constexpr double rounding = 1e-6;

/// A length over which the solid bends at a contact line.
struct Bend {
  double length;
  std::string name;
};

Bend shortest_bend(const Case& c) {
  const Substrate& s = *c.substrate;
  Bend shortest{0.25 * s.thickness, "a quarter of the layer"};
  const auto take = [&](const Bend& other) {
    if (other.length < shortest.length) shortest = other;
  };
  take({elastocapillary_length(c), "sigma/E"});
  if (s.surface_tension > 0) take({s.surface_tension / s.young_modulus(), "Upsilon/E"});
  return shortest;
}

bool wets_solid(const Case& c) {
  if (!c.fluid || !c.substrate) return false;
  return !c.films.empty() || std::any_of(c.droplets.begin(), c.droplets.end(),
                                         [&](const Droplet& droplet) { return sits_on_wall(c, droplet); });
}

}  // namespace

double widest_interface(const Case& c) { return shortest_bend(c).length; }

std::string warning_about_width(const Case& c) {
  if (!wets_solid(c)) return {};
  const Bend bend = shortest_bend(c);
  const double width = 2 * c.fluid->capillarity;
  if (width <= bend.length * (1 + rounding)) return {};
  const std::string told = "fluid.capillarity = " + short_text(c.fluid->capillarity) + ": the interface is " +
                           short_text(width) + " wide, and " + bend.name +
                           ", over which the solid bends at a contact line, is " + short_text(bend.length) + ": ";
  if (c.substrate->surface_tension == 0)
    return told +
           "the height of the ridge depends on the width, and without a surface tension of the solid it has no limit; "
           "give the solid what it has as substrate.surface_tension, then 'softwet converge CASE' gives the numbers at "
           "zero width";
  return told +
         "its ridge is 20 to 50 % lower than that of a real interface; 'softwet converge CASE' gives it at zero width, "
         "with an error bar";
}

}  // namespace softwet
