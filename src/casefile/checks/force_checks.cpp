// Cross checks of loads and needles.
#include <fmt/core.h>

#include "casefile/checks/checker.hpp"
#include "casefile/checks/stiff_parts.hpp"

namespace softwet {
namespace {

/// A box of the solid that something acts on. @param acts  "a load acts on"
void check_box_of_solid(const Checker& check, const std::string& table, const std::string& acts, const Numbers& lower,
                        const Numbers& upper) {
  const std::string box = table + ".box";
  if (!check.c.substrate)
    check.refuse(box, acts + " the solid",
                 fmt::format("add a [substrate] or remove the [[{}]]", table.substr(0, table.find('['))));
  Numbers top = check.c.domain.size;
  top.back() = check.c.substrate->thickness;
  check_corners(check, box, lower, upper, top, "solid");
}

void check_path(const Checker& check, const std::string& path, const std::vector<Profile>& entries) {
  check.with({path}, [&] {
    if (!entries.empty())
      check.require_axes(path, entries.size(), "write one displacement for each axis, the last is vertical");
  });
}

void check_load(const Checker& check, std::size_t index) {
  const Load& load = check.c.loads[index];
  const std::string table = fmt::format("load[{}]", index), force = table + ".force";
  check.with({table + ".box", "substrate", "substrate.thickness"},
             [&] { check_box_of_solid(check, table, "a load acts on", load.lower, load.upper); });
  check.with({force}, [&] {
    check.require_axes(force, load.force.size(), "write one component for each axis, the last is vertical");
  });
  check_path(check, table + ".path", load.path);
}

/// Beyond a stiffness the reading of a needle is made of the last digits of displacements.
void check_reading(const Checker& check, const std::string& key, const Needle& needle) {
  const double most = largest_needle_stiffness(check.c, needle);
  if (needle.stiffness <= most) return;
  const double rigid = rigid_needle_stiffness(check.c);
  check.refuse(
      key,
      fmt::format("must be in (0, {:.2g}] for this solid and path: the needle reads its stiffness times the gap "
                  "between its position and the solid, and beyond that the gap has fewer than three digits",
                  most),
      fmt::format("write for example {:.1g}{}", std::min(rigid, 0.1 * most),
                  rigid <= 0.1 * most ? ", which already holds the box rigidly: 1e4 E/h^2" : ""));
}

void check_needle(const Checker& check, std::size_t index) {
  const Needle& needle = check.c.needles[index];
  const std::string table = fmt::format("needle[{}]", index), path = table + ".path";
  check.with({table + ".box", "substrate", "substrate.thickness"},
             [&] { check_box_of_solid(check, table, "a needle holds a part of", needle.lower, needle.upper); });
  check_path(check, path, needle.path);
  check.with({table + ".stiffness", table + ".box", path, "domain.size", "domain.elements", "domain.grading",
              "substrate", "substrate.thickness", "substrate.young", "substrate.density"},
             [&] { check_reading(check, table + ".stiffness", needle); });
  check.with({path, "domain.coordinates"}, [&] {
    if (check.c.axisymmetric() && !needle.path.empty() && (needle.path[0].varies() || needle.path[0].number != 0))
      check.refuse(path, "must be 0 along the first axis with domain.coordinates = \"axisymmetric\"",
                   "write 0 there: a needle moves along the axis of symmetry alone");
  });
}

}  // namespace

void check_forces(const Checker& check) {
  for (std::size_t i = 0; i < check.c.loads.size(); ++i) check_load(check, i);
  for (std::size_t i = 0; i < check.c.needles.size(); ++i) check_needle(check, i);
}

}  // namespace softwet
