// Cross checks of the domain: its axes, elements, sides and coordinates.
#include <algorithm>
#include <cmath>
#include <limits>

#include "case/mesh.hpp"
#include "casefile/checks/checker.hpp"
#include "machine/memory.hpp"

namespace softwet {
namespace {

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
                 fmt::format("asks for {:.3g} unknowns, softwet can number {:.0f}", most_unknowns(check.c), most),
                 "use fewer elements");
  }
}

int least_periodic_elements(const Checker& check) { return 2 * check.c.domain.degree + 1; }

/// Around a periodic axis the box may reach across the ends, by less than a turn.
void check_fine_corners(const Checker& check, const std::string& key) {
  const Grading& grading = check.c.domain.grading;
  Numbers lower = grading.lower, upper = grading.upper;
  for (std::size_t axis = 0; axis < std::min({lower.size(), upper.size(), check.c.domain.size.size()}); ++axis) {
    const double length = check.c.domain.size[axis];
    if (check.c.boundary.side[axis][0] != Side::periodic || lower[axis] >= upper[axis]) continue;
    if (lower[axis] < -length * (1 + slack) || upper[axis] > 2 * length * (1 + slack))
      check.refuse(key, fmt::format("lies outside [{}, {}] along the periodic axis {}", -length, 2 * length, axis),
                   "move or shrink the box");
    if (upper[axis] - lower[axis] > length * (1 + slack))
      check.refuse(key, fmt::format("is longer than the periodic axis {}, whose length is {}", axis, length),
                   "shrink the box");
    if (lower[axis] < 0 || upper[axis] > length) lower[axis] = 0, upper[axis] = length;
  }
  check_corners(check, key, lower, upper, check.c.domain.size, "domain");
}

/// What is left of a periodic axis.
void check_periodic_elements(const Checker& check, const std::string& key) {
  const int least = least_periodic_elements(check);
  for (int axis = 0; axis < check.c.dimension(); ++axis) {
    const int left = elements_along(check.c, axis);
    if (check.c.boundary.side[axis][0] == Side::periodic && left < least)
      check.refuse(
          key, fmt::format("leaves {} elements along the periodic axis {}, which needs {} or more", left, axis, least),
          "write a larger box, a smaller domain.grading.ratio or domain.grading.coarsest, or more domain.elements");
  }
}

void check_grading(const Checker& check) {
  const Grading& grading = check.c.domain.grading;
  const std::string key = "domain.grading.box";
  if (grading.fine != FineElements::box) {
    if (!grading.lower.empty())
      check.refuse(key, fmt::format("is not used with fine = \"{}\"", word_of(grading.fine)), "write fine = \"box\"");
    return;
  }
  check_fine_corners(check, key);
  check_periodic_elements(check, key);
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
  const int least = least_periodic_elements(check);
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

}  // namespace

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

bool check_domain(const Checker& check) {
  const Case& c = check.c;
  check.with({"domain.size"}, [&] { check_size(check); });
  if (check.problems.about("domain.size")) return false;
  check.with({"domain.elements", "domain.degree"}, [&] { check_elements(check); });
  check.with({"domain.grading.box", "domain.grading.fine", "domain.grading.ratio", "domain.grading.coarsest",
              "domain.elements", "domain.degree", "substrate", "substrate.thickness", "boundary"},
             [&] { check_grading(check); });
  check_boundary(check);
  c.parts.each([&](const auto& part) { part.check(check); });
  check.with({"domain.coordinates"}, [&] {
    if (c.dimension() == 3 && check.document.entries.count("domain.coordinates"))
      check.refuse("domain.coordinates", "exists in 2D only, where it says what the two axes are", "remove it");
  });
  if (c.axisymmetric() && c.dimension() == 2) {
    check.with({"domain.coordinates", "boundary", "fluid", "substrate", "load", "droplet"},
               [&] { check_axis_of_symmetry(check); });
  }
  return true;
}

}  // namespace softwet
