// Cross checks of a resolved case.
#include "casefile/checks/case_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "case/gel.hpp"
#include "case/mesh.hpp"
#include "case/precision.hpp"
#include "casefile/checks/checker.hpp"

namespace softwet {
namespace {

void check_name(const Checker& check) {
  const std::string& name = check.c.name;
  const std::string& others = find_key("name")->letters;
  const bool plain = std::all_of(name.begin(), name.end(), [&](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) || others.find(letter) != std::string::npos;
  });
  const std::size_t most = find_key("name")->longest;
  if (name.size() > most)
    check.refuse("name", fmt::format("has {} letters, and may have {} at most", name.size(), most),
                 "it names the output folder, for example droplet_1");
  if (plain && !name.empty() && name.front() != '.') return;
  check.refuse("name", "must be letters, digits, '_', '-' or '.'", "it names the output folder, for example droplet_1");
}

/// A force on the fluid along a periodic axis would do work for ever: it has no potential energy. That of a solid has one.
void check_gravity(const Checker& check) {
  const auto& fluid = check.c.fluid;
  const auto& substrate = check.c.substrate;
  const std::string remedy = "write one component for each axis, the last is vertical";
  if (substrate && !substrate->gravity.empty())
    check.require_axes("substrate.gravity", substrate->gravity.size(), remedy);
  if (!fluid || fluid->gravity.empty()) return;
  check.require_axes("fluid.gravity", fluid->gravity.size(), remedy);
  for (std::size_t axis = 0; axis < fluid->gravity.size(); ++axis)
    if (fluid->gravity[axis] != 0 && check.periodic(axis))
      check.refuse("fluid.gravity", fmt::format("must be 0 along axis {}, whose sides are periodic", axis),
                   "write 0 there, or other sides");
}

void check_substrate(const Checker& check) {
  if (!check.c.substrate) return;
  const double thickness = check.c.substrate->thickness, height = check.height(), row = check.element_height();
  if (!check.c.fluid) {
    if (std::abs(thickness - height) <= slack * height) return;
    check.refuse("substrate.thickness", "must equal the domain height: without a [fluid] the domain is the solid alone",
                 fmt::format("write thickness = {} or add a [fluid]", height));
  }
  if (thickness >= height * (1 - slack)) {
    check.refuse("substrate.thickness", fmt::format("must be in (0, {}), below the domain height", height),
                 "leave room for the fluid, or remove [fluid] for a solid alone");
  }
  const double rows = thickness / row;
  if (std::abs(rows - std::round(rows)) * row <= slack * height && std::round(rows) >= 1) return;
  const double below = std::max(1.0, std::floor(rows)) * row, above = std::max(1.0, std::ceil(rows)) * row;
  const std::string choice =
      below == above ? fmt::format("{:.10g}", below) : fmt::format("{:.10g} or {:.10g}", below, above);
  check.refuse("substrate.thickness", fmt::format("must be a multiple of the element height {:.10g}", row),
               fmt::format("write thickness = {}, or change domain.elements", choice));
}

void check_surface_modulus(const Checker& check) {
  if (!check.c.substrate) return;
  const Numbers& moduli = check.c.substrate->surface_modulus;
  if (moduli.empty() || moduli.size() == 2) return;
  check.refuse("substrate.surface_modulus", "must be 2 numbers, lambda_s and G_s",
               "write for example surface_modulus = [0.004, 0.002]");
}

/// What a viscoelastic solid can be combined with. @param key  of what makes it one
void check_company_of_branches(const Checker& check, const std::string& key) {
  const Substrate& s = *check.c.substrate;
  if (!check.c.time.implicit() && check.c.time.scheme != TimeScheme::kick_drift)
    check.refuse(
        key,
        fmt::format("needs time.scheme = \"generalized_alpha\" or \"kick_drift\", not \"{}\", which does not move "
                    "branches",
                    word_of(check.c.time.scheme)),
        "write scheme = \"generalized_alpha\"");
  if (s.young.varies())
    check.refuse(key, "needs the same substrate.young in all of the solid: branches are the same everywhere",
                 "write a number as young");
  if (!s.prestretch.empty())
    check.refuse(key,
                 "excludes substrate.prestretch: the strain that branches remember counts from the undeformed solid",
                 "leave out prestretch, or write substrate.viscosity in place of branches");
}

void check_gel(const Checker& check) {
  const PowerLaw& gel = check.c.substrate->gel;
  const std::string key = "substrate.gel.decades";
  if (gel.decades.size() != 2)
    check.refuse(key, fmt::format("must be 2 numbers, not {}", gel.decades.size()),
                 "write the lowest and the highest decade, for example [-2, 2]");
  const double width = gel.decades[1] - gel.decades[0];
  if (width < 1 || width > 8)
    check.refuse(key, fmt::format("must span 1 to 8 decades, not {:.4g}", width),
                 "write the lowest decade first, for example [-2, 2]");
  if (gel.time == 0)
    check.refuse("substrate.gel.time", "must be above 0 with gel.exponent",
                 "write the time at which the modulus begins to grow, for example gel.time = 0.1");
}

void check_branches(const Checker& check) {
  if (!check.c.substrate || !check.c.substrate->has_branches()) return;
  const Substrate& s = *check.c.substrate;
  const std::string key = s.gel.acts() ? "substrate.gel.exponent" : "substrate.branch[0].modulus";
  check_company_of_branches(check, key);
  if (s.gel.acts()) check_gel(check);
  if (const std::size_t count = all_branches(s).size(); count > most_branches)
    check.refuse(key,
                 fmt::format("with {} branches in all, of which substrate.gel makes {}: there may be {}", count,
                             count - s.branches.size(), most_branches),
                 s.gel.acts() ? "write fewer substrate.gel.decades, or fewer [[substrate.branch]]"
                              : "write fewer [[substrate.branch]]");
}

void check_fibre(const Checker& check) {
  const std::string key = "substrate.fibre.azimuth";
  if (check.c.dimension() == 2 && check.document.entries.count(key))
    check.refuse(key, "exists in 3D only", "remove it: in 2D fibre.angle is the direction");
}

void check_steps(const Checker& check) {
  const TimeControl& time = check.c.time;
  check.with({"time.dt_min", "time.dt_initial"}, [&] {
    if (time.dt_min > time.dt_initial)
      check.refuse("time.dt_initial", fmt::format("must be at least time.dt_min = {}", time.dt_min), "lower dt_min");
  });
  check.with({"time.dt_initial", "time.dt_max"}, [&] {
    if (time.dt_initial > time.dt_max)
      check.refuse(check.document.entries.count("time.dt_initial") ? "time.dt_initial" : "time.dt_max",
                   fmt::format("dt_initial = {} must be at most dt_max = {}", time.dt_initial, time.dt_max),
                   "lower dt_initial or raise dt_max");
  });
}

/// Explicit schemes divide by the inertia of the solid.
void check_inertia(const Checker& check) {
  if (!check.c.substrate || check.c.substrate->inertia == Inertia::full || check.c.time.implicit()) return;
  check.refuse("substrate.inertia",
               fmt::format("cannot be \"none\" with time.scheme = \"{}\"", word_of(check.c.time.scheme)),
               "write inertia = \"full\", or time.scheme = \"generalized_alpha\"");
}

/// Where two materials of the solid meet, elements have to end.
void check_joint(const Checker& check) {
  const Case& c = check.c;
  if (!c.substrate || c.substrate->joint == 0) return;
  const double joint = c.substrate->joint, thickness = c.substrate->thickness;
  if (joint >= thickness * (1 - slack))
    check.refuse("substrate.joint", fmt::format("must be below the thickness {}", thickness), "write a lower joint");
  if (solid_elements(c) < 2)
    check.refuse("substrate.joint", "needs two rows of elements in the solid or more", "raise domain.elements");
  const int row = std::clamp(joint_element(c), 1, solid_elements(c) - 1);
  const double nearest = end_of_row(c, row);
  if (std::abs(nearest - joint) > slack * thickness)
    check.refuse("substrate.joint", "must be the end of a row of elements",
                 fmt::format("write joint = {:.10g}, or change domain.elements", nearest));
}

void check_material(const Checker& check) {
  if (!check.c.substrate || check.c.substrate->strain == Strain::finite ||
      check.c.substrate->material == Substrate{}.material)
    return;
  check.refuse("substrate.material", "is not used where substrate.strain = \"small\": that is Hooke's law",
               "write strain = \"finite\", or remove the material");
}

void check_precision(const Checker& check) {
  const SolverControl& solver = check.c.solver;
  if (solver.precision != PrecisionChoice::mixed) return;
  const std::string key = "solver.precision";
  switch (hindrance_of_single(check.c)) {
    case Hindrance::none:
      return;
    case Hindrance::scheme:
      check.refuse(key,
                   fmt::format("needs time.scheme = \"generalized_alpha\", not \"{}\"", word_of(check.c.time.scheme)),
                   "write \"automatic\": explicit schemes are always in double precision");
    case Hindrance::difference:
      check.refuse(key, "needs solver.krylov.jacobian = \"exact\"",
                   "write \"automatic\": differences of residuals have no digits left in single precision");
    case Hindrance::tolerance:
      check.refuse(key,
                   fmt::format("needs solver.krylov.rtol = {} or more, not {}", least_single_rtol, solver.krylov_rtol),
                   "write \"automatic\": linear solves in single precision end at its round-off");
  }
}

}  // namespace

void check_case(const Case& c, const Document& document, Problems& problems) {
  const Checker check{c, document, problems};
  check.with({"fluid", "substrate"}, [&] {
    if (c.fluid || c.substrate) return;
    throw CaseError("fluid", fmt::format("{}: there is neither [fluid] nor [substrate]; add the table of at least "
                                         "one material, see 'softwet explain fluid'",
                                         document.place));
  });
  check.with({"name"}, [&] { check_name(check); });
  check_steps(check);
  check.with({"substrate.inertia", "time.scheme"}, [&] { check_inertia(check); });
  check.with({"substrate.material", "substrate.strain"}, [&] { check_material(check); });
  check_output(check);
  if (!check_domain(check)) return;  // what follows needs the axes
  check.with({"fluid.gravity", "substrate.gravity", "boundary"}, [&] { check_gravity(check); });
  check_wall(check);
  check.with({"fluid", "substrate.thickness", "domain.elements"}, [&] { check_substrate(check); });
  check.with({"substrate.fibre.azimuth"}, [&] { check_fibre(check); });
  check.with({"substrate.branch", "substrate.gel", "substrate.young", "substrate.poisson", "substrate.strain",
              "substrate.prestretch", "time.scheme"},
             [&] { check_branches(check); });
  check.with({"substrate.surface_modulus"}, [&] { check_surface_modulus(check); });
  check_prestretch(check);
  check.with({"substrate.joint", "substrate.thickness", "domain.elements", "domain.grading.box"},
             [&] { check_joint(check); });
  check_forces(check);
  check_initial(check);
  check_probes(check);
  check.with({"solver.precision", "time.scheme", "solver.krylov.jacobian", "solver.krylov.rtol"},
             [&] { check_precision(check); });
}

}  // namespace softwet
