// Cross checks of a resolved case.
#include "casefile/case_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>

#include "case/precision.hpp"
#include "casefile/checker.hpp"
#include "casefile/field_times.hpp"
#include "machine/memory.hpp"
#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

void check_name(const Checker& check) {
  const std::string& name = check.c.name;
  const std::string& others = find_key("name")->letters;
  const bool plain = std::all_of(name.begin(), name.end(), [&](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) || others.find(letter) != std::string::npos;
  });
  if (plain && !name.empty() && name.front() != '.') return;
  check.refuse("name", "must be letters, digits, '_', '-' or '.'", "it names the output folder, for example droplet_1");
}

void check_size(const Checker& check) {
  const std::size_t count = check.c.domain.size.size();
  if (count == 2 || count == 3) return;
  check.refuse("domain.size", fmt::format("must be 2 numbers (2D) or 3 (3D), not {}", count),
               fmt::format("write for example size = [1.0, 0.5]{}", count == 4 || count == 6 ? decimal_comma : ""));
}

void check_elements(const Checker& check) {
  const Domain& domain = check.c.domain;
  check.require_axes("domain.elements", domain.elements.size(), "write one number of elements for each axis");
  if (constexpr double most = std::numeric_limits<int>::max(); most_unknowns(check.c) > most) {
    check.refuse("domain.elements",
                 fmt::format("asks for {:.3g} unknowns, softwet numbers {:.0f}", most_unknowns(check.c), most),
                 "take fewer elements");
  }
}

/// A box that is given by its corners, inside of [0, top] along each axis. @param place  what it has to lie in
void check_corners(const Checker& check, const std::string& key, const Numbers& lower, const Numbers& upper,
                   const Numbers& top, const char* place) {
  for (const Numbers& corner : {lower, upper})
    check.require_axes(key, corner.size(), "write box = [[lower corner], [upper corner]]");
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    if (lower[axis] >= upper[axis])
      check.refuse(key, fmt::format("is empty along axis {}", axis), "the first corner must lie below the second");
    if (lower[axis] < -slack * top[axis] || upper[axis] > top[axis] * (1 + slack))
      check.refuse(key, fmt::format("lies outside the {}, which is [0, {}] along axis {}", place, top[axis], axis),
                   "move or shrink the box");
  }
}

void check_grading(const Checker& check) {
  const Grading& grading = check.c.domain.grading;
  const std::string key = "domain.grading.box";
  if (grading.fine != "box") {
    if (!grading.lower.empty())
      check.refuse(key, fmt::format("is not used with fine = \"{}\"", grading.fine), "write fine = \"box\"");
    return;
  }
  check_corners(check, key, grading.lower, grading.upper, check.c.domain.size, "domain");
  const double wall = check.interface(), row = check.element_height();
  if (!check.c.substrate || !check.c.fluid) return;
  if (grading.lower.back() > wall - row * (1 - slack) || grading.upper.back() < wall + row * (1 - slack))
    check.refuse(key, fmt::format("must hold a row of elements on both sides of the wall at {:.10g}", wall),
                 fmt::format("let it reach from {:.10g} or lower to {:.10g} or higher", wall - row, wall + row));
}

void check_free(const Checker& check, std::size_t axis) {
  for (std::size_t end : {0, 1}) {
    const bool touches_fluid = check.c.fluid && (axis != check.vertical() || end == 1 || !check.c.substrate);
    if (touches_fluid && check.c.boundary.side[axis][end] == Side::free)
      check.refuse(side_name(axis, end, check.vertical()), "a side of the fluid cannot be free: it is closed to mass",
                   "write slip or no_slip");
  }
}

void check_periodic(const Checker& check, std::size_t axis) {
  const std::size_t vertical = check.vertical();
  const auto& [low, high] = check.c.boundary.side[axis];
  if (low != Side::periodic && high != Side::periodic) return;
  const std::string &low_name = side_name(axis, 0, vertical), &high_name = side_name(axis, 1, vertical);
  if (low != high) {
    const bool low_is = low == Side::periodic;
    check.refuse(low_is ? low_name : high_name, "a periodic side needs a periodic partner",
                 fmt::format("write {} = \"periodic\" too", low_is ? high_name : low_name));
  }
  if (axis == vertical && check.c.substrate) {
    check.refuse(high_name, "the vertical axis cannot be periodic with a substrate",
                 "write no_slip for the top and slip for the bottom");
  }
  const int least = 2 * check.c.domain.degree + 1;
  if (check.c.domain.elements[axis] < least) {
    check.refuse("domain.elements", fmt::format("a periodic axis needs {} elements or more", least),
                 fmt::format("axis {} has {}", axis, check.c.domain.elements[axis]));
  }
}

void check_boundary(const Checker& check) {
  if (check.c.dimension() == 2) {
    for (const char* key : {"boundary.front", "boundary.back"})
      check.with({key}, [&] {
        if (check.document.entries.count(key)) check.refuse(key, "exists in 3D only", "remove it from this 2D case");
      });
  }
  for (std::size_t axis = 0; axis <= check.vertical(); ++axis) {
    const std::string &low = side_name(axis, 0, check.vertical()), &high = side_name(axis, 1, check.vertical());
    check.with({low, high, "fluid", "substrate"}, [&] { check_free(check, axis); });
    check.with({low, high, "substrate", "domain.elements", "domain.degree"}, [&] { check_periodic(check, axis); });
  }
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

void check_box_of_load(const Checker& check, std::size_t index) {
  const std::string box = fmt::format("load[{}].box", index);
  const Load& load = check.c.loads[index];
  if (!check.c.substrate) check.refuse(box, "a load acts on the solid", "add a [substrate] or remove the [[load]]");
  Numbers top = check.c.domain.size;
  top.back() = check.c.substrate->thickness;
  check_corners(check, box, load.lower, load.upper, top, "solid");
}

void check_load(const Checker& check, std::size_t index) {
  const std::string box = fmt::format("load[{}].box", index), force = fmt::format("load[{}].force", index);
  check.with({box, "substrate", "substrate.thickness"}, [&] { check_box_of_load(check, index); });
  check.with({force}, [&] {
    check.require_axes(force, check.c.loads[index].force.size(),
                       "write one component for each axis, the last is vertical");
  });
  const std::string path = fmt::format("load[{}].path", index);
  check.with({path}, [&] {
    if (const std::size_t count = check.c.loads[index].path.size(); count > 0)
      check.require_axes(path, count, "write one displacement for each axis, the last is vertical");
  });
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

/// What points away from the axis of symmetry, or lies beside it, is a vector or a droplet of no axisymmetric scene.
void check_axis_of_symmetry(const Checker& check) {
  const Case& c = check.c;
  const std::string axial = "domain.coordinates = \"axisymmetric\"";
  if (c.boundary.side[0][0] != Side::slip)
    check.refuse("boundary.left", fmt::format("must be \"slip\" with {}: the left side is the axis of symmetry", axial),
                 "write left = \"slip\"");
  const auto require_upright = [&](const std::string& key, const Numbers& vector, const std::string& what) {
    if (!vector.empty() && vector[0] != 0)
      check.refuse(key, fmt::format("{} must be 0 along the first axis with {}, not {}", what, axial, vector[0]),
                   "write 0 there: what points to one side has no axis of symmetry");
  };
  if (c.fluid) require_upright("fluid.gravity", c.fluid->gravity, "the force");
  if (c.substrate) require_upright("substrate.gravity", c.substrate->gravity, "the force");
  for (std::size_t i = 0; i < c.loads.size(); ++i)
    require_upright(fmt::format("load[{}].force", i), c.loads[i].force, "the force");
  for (std::size_t i = 0; i < c.droplets.size(); ++i) {
    const Droplet& droplet = c.droplets[i];
    require_upright(fmt::format("droplet[{}].centre", i), droplet.centre, "the centre");
    require_upright(fmt::format("droplet[{}].velocity", i), droplet.velocity, "the velocity");
  }
}

/// Explicit schemes know no coordinates but those of the plane and of space.
void check_scheme_of_coordinates(const Checker& check) {
  if (check.c.time.scheme == implicit_scheme) return;
  check.refuse("time.scheme",
               fmt::format("must be \"{}\" with domain.coordinates = \"axisymmetric\", not \"{}\"", implicit_scheme,
                           check.c.time.scheme),
               fmt::format("write scheme = \"{}\", or compute the scene in the plane or in 3D", implicit_scheme));
}

/// Explicit schemes divide by the inertia of the solid.
void check_inertia(const Checker& check) {
  if (!check.c.substrate || check.c.substrate->inertia == "full" || check.c.time.scheme == implicit_scheme) return;
  check.refuse("substrate.inertia", fmt::format("cannot be \"none\" with time.scheme = \"{}\"", check.c.time.scheme),
               fmt::format("write inertia = \"full\", or time.scheme = \"{}\"", implicit_scheme));
}

/// A field of a material that the case does not have cannot be written.
void check_field_names(const Checker& check) {
  for (const std::string& name : check.c.output.field_select) {
    const FieldInfo& field = field_info(name);
    if ((field.in_fluid && check.c.fluid) || (field.in_solid && check.c.substrate)) continue;
    check.refuse("output.fields.select",
                 fmt::format("{} is a field of the {}", name, field.in_solid ? "solid" : "fluid"),
                 fmt::format("add a [{}] or leave the name out", field.in_solid ? "substrate" : "fluid"));
  }
}

void check_field_times(const Checker& check) {
  const OutputControl& output = check.c.output;
  const auto& times = output.field_times;
  const double multiples = count_of_multiples(check.c), room = most_field_files - static_cast<double>(times.size());
  if (room < 0) {
    check.refuse("output.fields.times",
                 fmt::format("has {} times, at most {} are possible", times.size(), most_field_files),
                 "leave some out");
  }
  if (multiples > room) {
    check.refuse("output.fields.every",
                 fmt::format("asks for {:.3g} field files up to time.end = {}, at most {} are possible", multiples,
                             check.c.time.end, most_field_files),
                 fmt::format("write every = {:.3g} or more", 1.01 * check.c.time.end / std::max(room - 1, 1.0)));
  }
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
    check.refuse("output.fields.times", "must increase", "sort the times and remove repeated ones");
  }
  for (std::size_t i = 0; i < check.c.loads.size(); ++i)
    if (check.problems.about(fmt::format("load[{}].start", i))) return;
  const double beginning = check.c.run_start() - check.c.clock_zero();
  if (!times.empty() && times.front() < beginning) {
    check.refuse("output.fields.times", fmt::format("must be at least {}, the start of the computation", beginning),
                 check.c.time.start == "equilibrium" ? "with time.start = \"equilibrium\" it begins at zero"
                                                     : "zero is the start of the first load");
  }
}

void check_track(const Checker& check) {
  const std::string key = "output.history.track";
  if (!check.document.entries.count(key)) return;
  if (check.c.dimension() == 2) check.refuse(key, "exists in 3D only", "remove it: in 2D the track is the x axis");
  const std::vector<double>& track = check.c.output.track;
  if (track.size() == 2 && std::hypot(track[0], track[1]) > 0) return;
  check.refuse(key, "must be 2 numbers, not both 0", "write a horizontal direction, for example track = [1, 1]");
}

void check_material(const Checker& check) {
  if (!check.c.substrate || check.c.substrate->strain == "finite" ||
      check.c.substrate->material == Substrate{}.material)
    return;
  check.refuse("substrate.material", "is not used where substrate.strain = \"small\": that is Hooke's law",
               "write strain = \"finite\", or remove the material");
}

void check_precision(const Checker& check) {
  const SolverControl& solver = check.c.solver;
  if (solver.precision == "double" || solver.precision == "automatic") return;
  const std::string key = "solver.precision";
  switch (hindrance_of_single(check.c)) {
    case Hindrance::none:
      return;
    case Hindrance::scheme:
      check.refuse(key, fmt::format("needs time.scheme = \"{}\", not \"{}\"", implicit_scheme, check.c.time.scheme),
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
  check.with({"output.fields.times", "output.fields.every", "time.end"}, [&] { check_field_times(check); });
  check.with({"domain.size"}, [&] { check_size(check); });
  if (problems.about("domain.size")) return;  // what follows needs the axes
  check.with({"domain.elements", "domain.degree"}, [&] { check_elements(check); });
  check.with({"domain.grading.box", "domain.grading.fine", "domain.elements", "substrate", "substrate.thickness"},
             [&] { check_grading(check); });
  check_boundary(check);
  check.with({"domain.coordinates"}, [&] {
    if (c.dimension() == 3 && document.entries.count("domain.coordinates"))
      check.refuse("domain.coordinates", "exists in 2D only, where it tells what the two axes are", "remove it");
  });
  if (c.axisymmetric() && c.dimension() == 2) {
    check.with({"domain.coordinates", "boundary", "fluid", "substrate", "load", "droplet"},
               [&] { check_axis_of_symmetry(check); });
    check.with({"time.scheme"}, [&] { check_scheme_of_coordinates(check); });
  }
  check.with({"fluid.gravity", "substrate.gravity", "boundary"}, [&] { check_gravity(check); });
  check.with({"fluid.wall_tension", "fluid.wall_law", "substrate"}, [&] { check_wall_tension(check); });
  check.with({"fluid", "substrate.thickness", "domain.elements"}, [&] { check_substrate(check); });
  for (std::size_t i = 0; i < c.loads.size(); ++i) check_load(check, i);
  check_initial(check);
  check.with({"output.fields.select", "fluid", "substrate"}, [&] { check_field_names(check); });
  check.with({"output.history.track"}, [&] { check_track(check); });
  check.with({"solver.precision", "time.scheme", "solver.krylov.jacobian", "solver.krylov.rtol"},
             [&] { check_precision(check); });
}

}  // namespace softwet
