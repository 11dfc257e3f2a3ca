// Cross checks of what is written and when.
#include <algorithm>
#include <cmath>
#include <functional>

#include "casefile/checks/checker.hpp"
#include "casefile/checks/field_times.hpp"
#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

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
                 check.c.time.start == StartState::equilibrium ? "with time.start = \"equilibrium\" it begins at zero"
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

}  // namespace

void check_output(const Checker& check) {
  check.with({"output.fields.times", "output.fields.every", "time.end"}, [&] { check_field_times(check); });
  check.with({"output.fields.select", "fluid", "substrate"}, [&] { check_field_names(check); });
  check.with({"output.history.track"}, [&] { check_track(check); });
}

}  // namespace softwet
