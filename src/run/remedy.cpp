#include "run/remedy.hpp"

#include <algorithm>
#include <cmath>

#include "case/text.hpp"
#include "foresight/forecast.hpp"
#include "foresight/measured.hpp"
#include "scene/groups.hpp"

namespace softwet {
namespace {

/// Settings so far from their defaults that a computation may stop because of them alone: they are looked at before
/// the scene is blamed. Empty where there are none.
std::string unusual_settings(const Case& c) {
  const SolverControl solver;
  const TimeControl time;
  std::string found;
  const auto tell = [&](bool unusual, const std::string& key, double value, double usual) {
    if (!unusual) return;
    found += (found.empty() ? "" : ", ") + key + " = " + short_text(value) + " (default " + short_text(usual) + ")";
  };
  if (c.time.implicit()) {
    tell(c.solver.newton_rtol > 10 * solver.newton_rtol, "solver.newton.rtol", c.solver.newton_rtol,
         solver.newton_rtol);
    tell(c.solver.newton_atol > 1e4 * solver.newton_atol, "solver.newton.atol", c.solver.newton_atol,
         solver.newton_atol);
    tell(2 * c.solver.newton_max < solver.newton_max, "solver.newton.max", c.solver.newton_max, solver.newton_max);
    tell(c.solver.krylov_rtol > 10 * solver.krylov_rtol, "solver.krylov.rtol", c.solver.krylov_rtol,
         solver.krylov_rtol);
    tell(4 * c.solver.krylov_max < solver.krylov_max, "solver.krylov.max", c.solver.krylov_max, solver.krylov_max);
  }
  tell(c.time.dt_min > 1e4 * time.dt_min, "time.dt_min", c.time.dt_min, time.dt_min);
  tell(c.time.tolerance > 25 * time.tolerance, "time.tolerance", c.time.tolerance, time.tolerance);
  return found;
}

std::string softer_than_its_loads(const Case& c) {
  const double length = elastocapillary_length(c);
  std::string soft = length > 0 ? "the elastocapillary length sigma/E is " + short_text(length) + ", the layer is " +
                                      short_text(c.substrate->thickness) + " thick; "
                                : "";
  if (c.fluid && length > measured::surely_held * longest_elastocapillary_length(c)) soft += gentle_start(c) + "; or ";
  if (c.loads.empty() && !c.needles.empty())
    return soft + "raise substrate.young, or move the needle more slowly and less far (needle[].path)";
  if (c.loads.empty()) return soft + "raise substrate.young";
  const std::string gentler = "raise substrate.young, lower load[].force or lengthen load[].ramp";
  if (c.substrate->material != MaterialModel::saint_venant_kirchhoff) return soft + gentler;
  return soft +
         "a Saint Venant-Kirchhoff solid loses its stiffness under strong compression, \"neo_hookean\" "
         "(substrate.material) does not: " +
         gentler;
}

/// The beginning of a list of what may help; empty where nothing begins to act.
std::string ramp_of_loads(const Case& c) {
  if (!c.loads.empty()) return "a longer load[].ramp, ";
  return c.needles.empty() ? "" : "a slower needle[].path, ";
}

std::string for_the_density(const Case& c) {
  const double h = c.spacing();
  if (c.fluid->wall_law == WallLaw::gradient &&
      std::max(90 - c.fluid->contact_angle.least(), c.fluid->contact_angle.most() - 90) > 60)
    return "near complete wetting or drying the wall law \"gradient\" drives the density out of its range: write "
           "fluid.wall_law = \"energy\"";
  if (too_soft(c)) return softer_than_its_loads(c);
  if (c.fluid->capillarity < 2 * h)
    return "the liquid-vapour interface is " + short_text(c.fluid->capillarity / h) +
           " elements wide: two resolve it, with more domain.elements or a larger fluid.capillarity";
  return ramp_of_loads(c) + "a larger fluid.viscosity or a tighter time.tolerance may help";
}

/// Between the angles of a range the force on a line changes within the speed of its creep, the faster the harder for
/// Newton's method.
std::string of_lines_that_stick(const Case& c) {
  const Fluid& fluid = *c.fluid;
  return "contact lines stick (fluid.contact_angle_range), and Newton's method may not find where: write a larger "
         "fluid.creep_speed than " +
         short_text(fluid.creep_speed) + ", for example " + short_text(std::min(1.0, 10 * fluid.creep_speed)) +
         " (up to 1), " + ramp_of_loads(c) + "more elements or a tighter time.tolerance";
}

/// The key of a load or needle that is not a number within the smallest steps after a time; empty where all are.
std::string load_without_value(const Case& c, double time) {
  constexpr int looks = 64;
  for (int i = 1; i <= looks; ++i) {
    const double t = time + 2 * c.time.dt_min * i / looks;
    for (std::size_t k = 0; k < c.loads.size(); ++k) {
      const std::string load = "load[" + std::to_string(k) + "].";
      if (!std::isfinite(c.loads[k].factor.at({0, 0, 0}, t))) return load + "factor";
      for (const Profile& shift : c.loads[k].path)
        if (!std::isfinite(shift.at({0, 0, 0}, t))) return load + "path";
    }
    for (std::size_t k = 0; k < c.needles.size(); ++k)
      for (std::size_t d = 0; d < c.needles[k].path.size(); ++d)
        if (!std::isfinite(c.needles[k].place(d, t))) return "needle[" + std::to_string(k) + "].path";
  }
  return "";
}

}  // namespace

std::string remedy(const Case& c, const Refusal& refusal, double time) {
  if (const std::string key = load_without_value(c, time); !key.empty())
    return key + " is not a number after t = " + short_text(time, 10) +
           ": bound what it divides by or takes a root of, for example with max";
  if (!c.time.implicit() && c.time.safety > 1)
    return "with time.safety = " + short_text(c.time.safety) +
           " the steps may be longer than the largest stable one: write time.safety = 0.9";
  if (const std::string settings = unusual_settings(c); !settings.empty())
    return "try the defaults first, for these settings are far from them: " + settings;
  const auto cause = refusal.cause;
  if (cause == Refusal::solid_inverted || cause == Refusal::mesh_folded) return softer_than_its_loads(c);
  if (cause == Refusal::close_packed || cause == Refusal::negative_density || cause == Refusal::density_of_moments)
    return for_the_density(c);
  const bool sticks = c.fluid && !c.fluid->contact_angle_range.empty();
  if (sticks && (cause == Refusal::newton || cause == Refusal::linear_solver)) return of_lines_that_stick(c);
  if (too_soft(c)) return softer_than_its_loads(c);
  if (cause == Refusal::beyond_bound)
    return "where the limit of explicit steps falls without end, the density, the mesh or the solid leaves its range: "
           "try time.scheme = \"generalized_alpha\", or a finer mesh; where it is only short, write a smaller "
           "time.dt_min";
  if (cause == Refusal::linear_solver)
    return "solver.krylov.preconditioner = \"automatic\", or more iterations with solver.krylov.max";
  return "a finer mesh, " + std::string(c.fluid ? "a larger fluid.capillarity, " : "") + ramp_of_loads(c) +
         "or a tighter time.tolerance may help";
}

}  // namespace softwet
