#include "casefile/checks/stiff_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

/// Part of the force of a deformed solid that may be lost in the reading of a needle.
constexpr double lost_of_reading = 1e-3;
/// A part that is stiffer by this factor than the Young modulus takes the digits of single precision, in which linear
/// solves have their matrices, from what is softer. docs/limits.md has what was measured.
constexpr double stiffest_part = 1e7;

double size_of_solid(const Case& c) {
  double most = c.substrate->thickness;
  for (std::size_t d = 0; d + 1 < c.domain.size.size(); ++d) most = std::max(most, c.domain.size[d]);
  return most;
}

/// The largest displacement of a needle that its path names.
double way_of(const Needle& needle) {
  double most = 0;
  for (const Profile& along : needle.path)
    for (const double place : {along.least(), along.most()})
      if (std::isfinite(place)) most = std::max(most, std::abs(place));
  return most;
}

}  // namespace

double largest_needle_stiffness(const Case& c, const Needle& needle) {
  const double size = size_of_solid(c), moved = std::max(size, way_of(needle));
  return lost_of_reading * c.substrate->young_modulus() / (std::numeric_limits<double>::epsilon() * size * moved);
}

double rigid_needle_stiffness(const Case& c) {
  constexpr double rigid = 1e4;
  return rigid * c.substrate->density * c.substrate->young.most() / (c.shortest() * c.shortest());
}

void warn_of_stiff_parts(const Case& c, std::vector<std::string>& found) {
  if (!c.substrate) return;
  const Substrate& solid = *c.substrate;
  const double young = solid.young_modulus();
  const auto tell = [&](const std::string& key, const std::string& what, double stiffness, double scale,
                        const std::string& most) {
    if (stiffness <= stiffest_part * scale) return;
    found.push_back(fmt::format(
        "{} makes {} {:.2g} times as stiff as the solid, which has the Young modulus {:.3g}: beyond {:g} times the "
        "digits of linear solves do not hold both, and displacements and energies may be wrong in states that count as "
        "converged (docs/limits.md); write at most {}, where that part hardly stretches any more",
        key, what, stiffness / scale, young, stiffest_part, most));
  };
  const double fibre = 4 * solid.fibre.stiffness, face = solid.modulus_of_surface(), h = c.shortest();
  tell(fmt::format("substrate.fibre.stiffness = {:g}", solid.fibre.stiffness), "fibres", fibre, young,
       fmt::format("{:.2g}", 0.95 * stiffest_part / 4 * young));
  if (face > 0)
    tell(fmt::format("substrate.surface_modulus = [{:g}, {:g}]", solid.surface_modulus[0], solid.surface_modulus[1]),
         fmt::format("a layer of one element, {:.3g},", h), face, young * h,
         fmt::format("[{:.2g}, 0]", 0.95 * stiffest_part * young * h));
}

}  // namespace softwet
