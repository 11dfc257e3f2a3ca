#include "casefile/checks/grading_advice.hpp"

#include <fmt/core.h>

#include <array>

#include "case/cap.hpp"
#include "case/mesh.hpp"
#include "casefile/checks/fine_box.hpp"

namespace softwet {
namespace {

struct SampledRange {
  double low, high;
  bool holds(double x) const { return low <= x && x <= high; }
};

// From which the study sampled_graded takes its scenes, and what it asks and finds kept: the difference of paths after
// the start of the load, over the distance that the droplet travels, in per cent. docs/verification/sampled_graded.md
constexpr SampledRange sampled_angle{60, 110}, sampled_young{0.6, 1.5}, sampled_poisson{0.25, 0.45},
    sampled_temperature{0.385, 0.395};
constexpr int sampled_scenes = 8;
constexpr double path_kept = 0.5;

bool is_sampled_fluid(const Fluid& fluid) {
  return !fluid.contact_angle.varies() && sampled_angle.holds(fluid.contact_angle.number) &&
         sampled_temperature.holds(fluid.temperature) && !fluid.resists_lines() && fluid.gravity.empty() &&
         fluid.ambient == Phase::vapour && fluid.wall_law == WallLaw::gradient && fluid.wall_stretch_exponent == 0 &&
         fluid.traction == Traction::layer;
}

bool is_sampled_solid(const Substrate& solid) {
  return !solid.young.varies() && sampled_young.holds(solid.young_modulus()) && sampled_poisson.holds(solid.poisson) &&
         solid.fibre.stiffness == 0 && solid.joint == 0 && solid.material == MaterialModel::saint_venant_kirchhoff &&
         solid.strain == Strain::finite && solid.prestretch.empty() && !solid.has_branches() && solid.viscosity == 0 &&
         solid.bulk_viscosity == 0 && solid.surface_tension == 0 && solid.surface_tension_wet == 0 &&
         solid.surface_modulus.empty() && solid.gravity.empty();
}

/// Whether nothing but the loads acts on the droplet and the layer between sides on which both slide.
bool is_otherwise_plain(const Case& c) {
  const auto slides = [](const std::array<Side, 2>& sides) { return sides[0] == Side::slip && sides[1] == Side::slip; };
  bool plain = c.films.empty() && c.waves.empty() && c.needles.empty() && !c.initial && slides(c.boundary.side[0]);
  c.parts.each([&](const auto& part) { plain = plain && !part.acts(); });
  return plain;
}

}  // namespace

double share_left_by_grading(const Case& c) {
  if (!c.domain.grading.lower.empty()) return 1;
  Case graded = c;
  graded.domain.grading.fine = FineElements::automatic;
  choose_fine_box(graded);
  return share_of_elements(graded);
}

bool is_sampled_pull(const Case& c) {
  if (c.dimension() != 2 || c.axisymmetric() || !c.fluid || !c.substrate || c.domain.degree != 2) return false;
  if (c.droplets.size() != 1 || !is_otherwise_plain(c) || !sits_on_wall(c, c.droplets[0]) || c.loads.empty())
    return false;
  if (!c.time.implicit() || c.time.start != StartState::initial) return false;
  return is_sampled_fluid(*c.fluid) && is_sampled_solid(*c.substrate);
}

std::string result_of_sampled_pulls() {
  return fmt::format("within {} % of its way in {} sampled scenes of this kind", path_kept, sampled_scenes);
}

std::string advice_on_grading(const Case& c) {
  if (!is_sampled_pull(c)) return {};
  const double share = share_left_by_grading(c);
  if (!is_worth_grading(share)) return {};
  return fmt::format(
      "domain.grading.fine = \"automatic\" would leave {:.0f} % of the elements, and the path of the droplet as it is, "
      "{}",
      100 * share, result_of_sampled_pulls());
}

}  // namespace softwet
