#include <cmath>
#include <iomanip>

#include "case/gel.hpp"
#include "case/mesh.hpp"
#include "case/text.hpp"
#include "casefile/checks/field_times.hpp"
#include "casefile/checks/grading_advice.hpp"
#include "casefile/formula/profiles.hpp"
#include "cli/core/describe.hpp"
#include "kernels/solid/isotropic.hpp"
#include "scene/equilibrium.hpp"
#include "scene/groups.hpp"
#include "scene/prestretch.hpp"

namespace softwet {
namespace {

std::vector<Line> stiffness(const Substrate& s) {
  const auto solid = LameParameters::from(s.young_modulus(), s.poisson);
  const std::string most = s.young.varies() ? " to " + formatted(s.density * s.young.most(), "%.4g") : "";
  if (!most.empty())
    return {{"Young modulus", formatted(s.young_modulus(), "%.4g") + most + " a b^2 (density x young)"}};
  return {{"Young modulus", formatted(s.young_modulus(), "%.4g") + " a b^2 (density x young)"},
          {"shear modulus", formatted(solid.shear_modulus, "%.4g") + " a b^2"},
          {"first Lame parameter lambda", formatted(solid.lambda, "%.4g") + " a b^2"}};
}

std::vector<Line> branches(const Substrate& s) {
  std::vector<Line> lines;
  double sum = s.shear_modulus();
  int number = 0;
  for (const Branch& branch : all_branches(s)) {
    sum += branch.modulus;
    lines.push_back({"branch " + std::to_string(++number),
                     formatted(branch.modulus, "%.4g") + " a b^2, fades in " + formatted(branch.time, "%.4g")});
  }
  lines.push_back({"shear modulus at once", formatted(sum, "%.4g") + " a b^2, where the viscosity allows that"});
  if (!s.gel.acts()) return lines;
  const GelFit fit = GelFit::of(s.shear_modulus(), s.gel);
  lines.push_back({"viscosity of the power law", formatted(fit.viscosity, "%.4g") + " L0 b sqrt(ab)"});
  lines.push_back({"largest error of its modulus",
                   formatted(100 * fit.error(s.shear_modulus(), s.gel), "%.1f") + " % at angular frequencies from " +
                       formatted(std::pow(10, s.gel.decades[0]) / s.gel.time, "%.3g") + " to " +
                       formatted(std::pow(10, s.gel.decades[1]) / s.gel.time, "%.3g") + " sqrt(ab)/L0"});
  return lines;
}

/// Lines about the prestretch of the layer where its displacement is 0.
std::vector<Line> prestretch(const Case& c) {
  const Substrate& s = *c.substrate;
  const LameParameters solid = stiffest_of(s);
  const Prestretch p = prestretch_of(c, solid);
  const Matrix<double, 3> stress = stress_at_rest(c, solid);
  const int up = c.dimension() - 1;
  const std::string names = c.axisymmetric() ? "r" : "xy";
  std::string stretches;
  std::vector<Line> lines;
  for (int d = 0; d < up; ++d) stretches += formatted(p.stretch[d], "%.5g") + " along " + names[d] + ", ";
  lines.push_back({"stretch", stretches + formatted(p.stretch[up], "%.5f") + " upright"});
  lines.push_back({"volume over that before", formatted(p.volume_ratio(), "%.5f")});
  lines.push_back({"thickness before", formatted(s.thickness / p.stretch[up], "%.5g") + " L0"});
  for (int d = 0; d < up; ++d)
    lines.push_back(
        {std::string("stress along ") + names[d], formatted(stress(d, d), "%.4g") + " a b^2 (" +
                                                      formatted(stress(d, d) / solid.shear_modulus, "%.4g") + " G" +
                                                      (s.young.varies() ? ", where the solid is stiffest)" : ")")});
  return lines;
}

std::vector<Line> equilibrium(const Fluid& fluid) {
  const Coexistence flat = coexistence(fluid.temperature);
  return {{"density of the vapour", formatted(flat.density_vapour, "%.10g") + " b"},
          {"density of the liquid", formatted(flat.density_liquid, "%.10g") + " b"},
          {"surface tension", formatted(surface_tension(fluid), "%.10g") + " a b^2 L0"}};
}

/// What contact lines resist with.
std::vector<Line> contact_lines(const Fluid& fluid) {
  std::vector<Line> lines;
  const double sigma = surface_tension(fluid);
  if (fluid.hysteresis() > 0) {
    lines.push_back({"static contact angle", formatted(fluid.contact_angle.number, "%.6g") + " degrees"});
    lines.push_back({"force that a droplet holds (2D)", formatted(2 * sigma * fluid.hysteresis(), "%.4g") +
                                                            " a b^2 L0, sigma (cos(receding) - cos(advancing))"});
    lines.push_back({"creep at half of that force", formatted(fluid.creep_speed / std::sqrt(3), "%.2g") + " sqrt(ab)"});
  }
  if (fluid.line_friction > 0)
    lines.push_back({"cosine lost to line friction",
                     formatted(fluid.line_friction / sigma, "%.4g") + " for a speed of sqrt(ab), mu_f / sigma"});
  return lines;
}

/// Lines about a wall whose stretch changes its contact angle.
std::vector<Line> stretched_wall(const Case& c) {
  const Fluid& fluid = *c.fluid;
  std::vector<Line> lines{{"area over that before", formatted(c.area_of_prestretch(), "%.5g")}};
  if (fluid.contact_angle.varies()) return lines;
  for (const double more : {1.0, 1.1}) {
    const double cosine = c.cosine_factor() * std::pow(more, -fluid.wall_stretch_exponent) *
                          std::cos(fluid.contact_angle.number * M_PI / 180);
    lines.push_back({more == 1 ? "effective contact angle" : "where its area is 10 % larger",
                     formatted(std::acos(cosine) * 180 / M_PI, "%.5g") + " degrees"});
  }
  return lines;
}

std::vector<Line> profiles(const Case& c) {
  std::vector<Line> lines;
  for (const ProfileRange& range : profile_ranges(c))
    lines.push_back(
        {range.key, formatted(range.least, "%.6g") + " to " + formatted(range.most, "%.6g") + " " + range.over});
  return lines;
}

/// What grading would spare where elements are equal.
std::vector<Line> grading_to_be_had(const Case& c) {
  const double share = share_left_by_grading(c);
  if (!is_worth_grading(share)) return {};
  return {{"elements", "all equal; domain.grading.fine = \"automatic\" would leave " + formatted(100 * share, "%.0f") +
                           " % of them"},
          {"path of the droplet", is_sampled_pull(c) ? "as it is, " + result_of_sampled_pulls()
                                                     : "not measured in scenes of this kind: compare a short run"}};
}

/// How elements are graded; of equal ones what grading would spare.
std::vector<Line> grading(const Case& c) {
  std::vector<Line> lines;
  if (c.domain.grading.lower.empty()) return grading_to_be_had(c);
  for (int d = 0; d < c.dimension(); ++d) {
    const std::vector<double> breaks = graded_breaks(c, d);
    const std::string axis = "axis " + std::to_string(d);
    if (breaks.empty()) {
      lines.push_back(
          {axis, std::to_string(c.domain.elements[d]) + " equal elements: grading would spare less than a twentieth"});
      continue;
    }
    double longest = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) longest = std::max(longest, breaks[i + 1] - breaks[i]);
    const FinePart fine = fine_part(c, d);
    lines.push_back({axis, std::to_string(breaks.size() - 1) + " elements in place of " +
                               std::to_string(c.domain.elements[d]) + ", of " + formatted(fine_length(c, d), "%.4g") +
                               " to " + formatted(longest, "%.4g") + "; fine from " +
                               formatted(std::max(fine.low, 0.0), "%.4g") + " to " +
                               formatted(std::isinf(fine.high) ? c.domain.size[d] : fine.high, "%.4g")});
  }
  lines.push_back({"elements", formatted(100 * share_of_elements(c), "%.0f") + " % of those of the equal mesh"});
  return lines;
}

void print_groups(const Case& c, std::ostream& out) {
  std::vector<Line> numbers, times;
  for (const Group& group : groups(c)) {
    const bool is_time = group.name.rfind("time_", 0) == 0;
    std::string value = formatted(group.value, "%.4g");
    value.resize(std::max<std::size_t>(value.size(), 11), ' ');
    (is_time ? times : numbers).push_back({group.name, value + " " + group.meaning});
  }
  if (!numbers.empty()) print_section(out, "dimensionless groups (R: largest droplet, Hs: thickness)", numbers);
  if (!times.empty()) print_section(out, "time scales, in L0/sqrt(ab)", times);
}

/// One line of the clock: an event, its run time and its t.
Line event(const Case& c, const std::string& name, double run_time) {
  std::string first = formatted(run_time, "%.10g");
  first.resize(std::max<std::size_t>(first.size(), 16), ' ');
  return {name, first + formatted(run_time - c.clock_zero() + 0.0, "%.10g")};
}

std::vector<Line> clock(const Case& c) {
  const double zero = c.clock_zero();
  std::vector<Line> lines{{"", "run time        t"}, event(c, "beginning", c.run_start())};
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    const std::string name = "load[" + std::to_string(i) + "]";
    lines.push_back(event(c, name + " starts", c.loads[i].start));
    lines.push_back(event(c, name + " has its full force", c.loads[i].start + c.loads[i].ramp));
  }
  if (const auto times = field_times(c); !times.empty()) {
    lines.push_back(event(c, "first of " + std::to_string(times.size()) + " field times", zero + times.front()));
    if (times.size() > 1) lines.push_back(event(c, "last field time", zero + times.back()));
  }
  lines.push_back(event(c, "end", zero + c.time.end));
  return lines;
}

}  // namespace

void print_section(std::ostream& out, const std::string& title, const std::vector<Line>& lines) {
  out << title << "\n";
  for (const Line& line : lines) out << "  " << std::left << std::setw(31) << line.name << " " << line.value << "\n";
}

void describe_scene(const Case& c, std::ostream& out) {
  if (c.substrate) print_section(out, "stiffness of the solid", stiffness(*c.substrate));
  if (c.substrate && c.substrate->has_branches())
    print_section(out, "viscoelastic branches of the solid", branches(*c.substrate));
  if (c.substrate && !c.substrate->prestretch.empty())
    print_section(out, "prestretch of the solid, where the displacement is 0", prestretch(c));
  if (c.fluid) print_section(out, "equilibrium", equilibrium(*c.fluid));
  if (c.fluid && c.fluid->resists_lines()) print_section(out, "contact lines", contact_lines(*c.fluid));
  if (c.fluid && c.fluid->wall_stretch_exponent > 0)
    print_section(out, "stretch of the wall, where the displacement is 0", stretched_wall(c));
  if (const auto lines = profiles(c); !lines.empty()) print_section(out, "numbers that vary", lines);
  if (const auto lines = grading(c); !lines.empty()) print_section(out, "graded elements", lines);
  print_groups(c, out);
  print_section(out, "clock (t is the time in all results, 0 at the start of the first load)", clock(c));
}

}  // namespace softwet
