// Cross checks of the wall that a fluid wets: its tension, its angles, and what contact lines lose.
#include <fmt/core.h>

#include <cmath>

#include "casefile/checks/checker.hpp"

namespace softwet {
namespace {

void check_wall_tension(const Checker& check) {
  if (!check.c.fluid || check.c.fluid->wall_tension == WallTensionModel::none) return;
  const std::string key = "fluid.wall_tension";
  if (!check.c.substrate) check.refuse(key, "needs a solid: a rigid wall does not feel it", "remove it");
  if (check.c.fluid->wall_law != WallLaw::energy)
    check.refuse(key, "needs the wall energy, whose derivative it is", "write wall_law = \"energy\"");
  if (check.c.has_wet_tension_by_hand())
    check.refuse("substrate.surface_tension_wet",
                 "counts the tension below liquid twice with fluid.wall_tension = \"acts\"",
                 "remove it: Young's law gives it");
}

/// The stretch of the wall changes the effective contact angle.
void check_stretch_exponent(const Checker& check) {
  if (!check.c.fluid || check.c.fluid->wall_stretch_exponent == 0) return;
  const std::string key = "fluid.wall_stretch_exponent";
  const Fluid& fluid = *check.c.fluid;
  if (!check.c.substrate) check.refuse(key, "needs a solid: a rigid wall is never stretched", "remove it");
  if (fluid.wall_law != WallLaw::energy)
    check.refuse(key, "belongs to the wall energy, which the law \"gradient\" lacks", "write wall_law = \"energy\"");
  const double factor = check.c.cosine_factor();
  for (const double angle : {fluid.contact_angle.least(), fluid.contact_angle.most()}) {
    const double cosine = std::cos(angle * 3.14159265358979323846 / 180);
    if (std::abs(factor * cosine) <= 1) continue;
    const double room = std::log(std::abs(cosine)) / std::log(check.c.area_of_prestretch());
    check.refuse(key,
                 fmt::format("gives the wall with substrate.prestretch an effective contact angle whose cosine is "
                             "{:.4g}: a contact angle of {:.6g} degrees is complete wetting or drying there",
                             factor * cosine, angle),
                 fmt::format("write an exponent below {:.4g}, or an angle closer to 90 degrees", room));
  }
}

/// Receding and advancing angle, and the static angle beside them.
void check_angle_range(const Checker& check) {
  if (!check.c.fluid || check.c.fluid->contact_angle_range.empty()) return;
  const std::string key = "fluid.contact_angle_range";
  const Fluid& fluid = *check.c.fluid;
  const Numbers& range = fluid.contact_angle_range;
  if (range.size() != 2)
    check.refuse(key, fmt::format("must be 2 numbers, not {}", range.size()),
                 "write the receding and the advancing angle, for example [65, 85]");
  if (range[0] >= range[1])
    check.refuse(key, "must have the receding angle first, below the advancing one",
                 range[0] > range[1] ? fmt::format("write [{}, {}]", range[1], range[0])
                                     : fmt::format("without hysteresis write contact_angle = {}", range[0]));
  if (fluid.contact_angle.varies())
    check.refuse(key, "cannot be combined with a fluid.contact_angle that varies along the wall", "write one of them");
  constexpr double digits = 1e-6;  // degrees
  const double middle = fluid.middle_of_range();
  if (std::abs(fluid.contact_angle.number - middle) > digits)
    check.refuse("fluid.contact_angle",
                 fmt::format("contradicts fluid.contact_angle_range = [{}, {}]: the static angle has the mean of their "
                             "cosines, {:.10g} degrees",
                             range[0], range[1], middle),
                 "remove contact_angle, or write that number");
}

/// The rate of the density at the wall is part of the equation of the potential.
void check_line_friction(const Checker& check) {
  if (!check.c.fluid || !check.c.fluid->resists_lines()) return;
  const Fluid& fluid = *check.c.fluid;
  const std::string key = fluid.line_friction > 0 ? "fluid.line_friction" : "fluid.contact_angle_range";
  if (fluid.wall_law != WallLaw::energy)
    check.refuse(key, "needs the wall energy: the law \"gradient\" has no energy that a moving line could lose",
                 "write wall_law = \"energy\"");
  if (!check.c.time.implicit())
    check.refuse(key,
                 fmt::format("needs time.scheme = \"generalized_alpha\", not \"{}\": explicit steps compute the "
                             "potential before they know the rate of the density at the wall, on which it then depends",
                             word_of(check.c.time.scheme)),
                 "write scheme = \"generalized_alpha\"");
  if (check.periodic(check.vertical()))
    check.refuse(key, "needs a wall, and the bottom is periodic", "remove it, or write another boundary.bottom");
  if (fluid.contact_angle.varies())
    check.refuse(key,
                 "needs the same contact angle along the whole wall: its friction is made with the sine of that angle",
                 "write a number as contact_angle");
  constexpr double least = 5;  // degrees
  const double angle = fluid.contact_angle.number;
  if (fluid.line_friction > 0 && (angle < least || angle > 180 - least))
    check.refuse(key,
                 fmt::format("needs a contact angle in [{0}, {1}], not {2:.6g}: a flatter wedge spreads its friction "
                             "over a line without bounds",
                             least, 180 - least, angle),
                 "write such a contact_angle");
}

}  // namespace

void check_wall(const Checker& check) {
  check.with({"fluid.wall_tension", "fluid.wall_law", "substrate"}, [&] { check_wall_tension(check); });
  check.with(
      {"fluid.wall_stretch_exponent", "fluid.contact_angle", "fluid.wall_law", "substrate", "substrate.prestretch"},
      [&] { check_stretch_exponent(check); });
  check.with({"fluid.contact_angle_range", "fluid.contact_angle"}, [&] { check_angle_range(check); });
  check.with({"fluid.contact_angle_range", "fluid.contact_angle", "fluid.line_friction", "fluid.wall_law",
              "time.scheme", "boundary"},
             [&] { check_line_friction(check); });
}

}  // namespace softwet
