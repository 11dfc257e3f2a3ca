// Cross checks of probes: a place that is one, a quantity that is there, a name of their own.
#include <algorithm>
#include <cctype>

#include "casefile/checks/checker.hpp"
#include "observe/host/probe_quantity.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

void check_name_of_probe(const Checker& check, std::size_t index) {
  const Case& c = check.c;
  const std::string key = fmt::format("probe[{}].name", index), &name = c.probes[index].name;
  const auto fits = [](unsigned char letter) { return std::isalnum(letter) || letter == '_'; };
  if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])) ||
      !std::all_of(name.begin(), name.end(), fits))
    check.refuse(key, "must be letters, digits or '_', and begin with a letter", "it names a column of history.csv");
  const std::vector<std::string> others =
      history_names(c.dimension(), c.droplets.size(), c.films.size(), c.needles.size());
  if (std::find(others.begin(), others.end(), name) != others.end())
    check.refuse(key, "is the name of a column that history.csv has already", "choose another name");
  for (std::size_t before = 0; before < index; ++before)
    if (c.probes[before].name == name)
      check.refuse(key, fmt::format("is the name of probe[{}] too", before), "give each probe a name of its own");
}

/// One corner is given for a point; for a box two, of which the first lies below the second or beside it.
void check_corners_of_probe(const Checker& check, const std::string& key, const Probe& probe) {
  const bool point = !probe.point.empty();
  for (const Numbers& corner : {probe.low(), probe.high()})
    check.require_axes(key, corner.size(),
                       point ? "write one coordinate for each axis" : "write box = [[lower corner], [upper corner]]");
  for (std::size_t axis = 0; axis <= check.vertical(); ++axis) {
    const double low = probe.low()[axis], high = probe.high()[axis], top = check.c.domain.size[axis];
    if (low > high)
      check.refuse(key, fmt::format("has its corners in the wrong order along axis {}", axis),
                   "the first corner must not lie above the second");
    if (low < -slack * top || high > top * (1 + slack))
      check.refuse(key, fmt::format("lies outside the domain, which is [0, {}] along axis {}", top, axis),
                   "move or shrink it");
  }
}

/// A quantity of the fluid is looked at above the wall, one of the solid below.
void check_side_of_wall(const Checker& check, const std::string& key, const Probe& probe) {
  const FieldInfo& field = *probe_quantity(probe.quantity).field;
  const double wall = check.interface(), room = slack * check.height();
  const bool above = probe.low().back() >= wall - room, below = probe.high().back() <= wall + room;
  if ((field.in_fluid && check.c.fluid && above) || (field.in_solid && check.c.substrate && below)) return;
  if (field.in_fluid && field.in_solid)
    check.refuse(key, fmt::format("lies on both sides of the wall at {}", wall), "write one probe for each side");
  check.refuse(key,
               fmt::format("lies {} the wall at {}, and {} is a quantity of the {}", field.in_fluid ? "below" : "above",
                           wall, probe.quantity, field.in_fluid ? "fluid" : "solid"),
               "move it to the other side");
}

void check_place_of_probe(const Checker& check, std::size_t index) {
  const Probe& probe = check.c.probes[index];
  const std::string name = fmt::format("probe[{}]", index), point = name + ".point", box = name + ".box";
  if (probe.point.empty() == probe.lower.empty())
    check.refuse(point, probe.point.empty() ? "or box is missing" : "is given, and a box too",
                 "write point = [...] or box = [[lower corner], [upper corner]]");
  const std::string& key = probe.point.empty() ? box : point;
  check_corners_of_probe(check, key, probe);
  check_side_of_wall(check, key, probe);
  if (probe.operation != ProbeOperation::value || probe.low() == probe.high()) return;
  check.refuse(check.document.entries.count(name + ".operation") ? name + ".operation" : box,
               "the operation \"value\" belongs to a point",
               "write operation = \"mean\", \"integral\", \"max\" or \"min\"");
}

void check_quantity(const Checker& check, std::size_t index) {
  const std::string key = fmt::format("probe[{}].quantity", index), &name = check.c.probes[index].quantity;
  const ProbeQuantity quantity = probe_quantity(name);
  const FieldInfo& field = *quantity.field;
  if (quantity.dimension > check.c.dimension()) check.refuse(key, "exists in 3D only", "choose another component");
  if ((field.in_fluid && check.c.fluid) || (field.in_solid && check.c.substrate)) return;
  check.refuse(key, fmt::format("is a quantity of the {}", field.in_solid ? "solid" : "fluid"),
               fmt::format("add a [{}] or remove the probe", field.in_solid ? "substrate" : "fluid"));
}

}  // namespace

void check_probes(const Checker& check) {
  for (std::size_t i = 0; i < check.c.probes.size(); ++i) {
    const std::string probe = fmt::format("probe[{}]", i), quantity = probe + ".quantity";
    check.with({probe + ".name"}, [&] { check_name_of_probe(check, i); });
    check.with({quantity, "fluid", "substrate"}, [&] { check_quantity(check, i); });
    check.with({quantity, probe + ".point", probe + ".box", probe + ".operation", "substrate.thickness"},
               [&] { check_place_of_probe(check, i); });
  }
}

}  // namespace softwet
