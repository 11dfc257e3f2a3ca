// Document to Case: required keys, defaults, checks.
#include "casefile/case_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "case/error.hpp"
#include "casefile/checks/case_checks.hpp"
#include "casefile/checks/fine_box.hpp"
#include "casefile/checks/stiff_parts.hpp"
#include "casefile/formula/jumps.hpp"
#include "casefile/formula/profiles.hpp"
#include "casefile/laboratory.hpp"
#include "casefile/schema/quality.hpp"
#include "casefile/text/document.hpp"

namespace softwet {
namespace {

std::size_t entries_of(const Document& document, const std::string& table) {
  const Table* known = find_table(table);
  if (known && known->count(Case{}) > 0) return 1;  // top of the file, domain, time, ... are always there
  const auto found = document.table_count.find(table);
  return found == document.table_count.end() ? 0 : found->second;
}

[[noreturn]] void reject_missing(const Document& document, const Key& key, std::size_t index) {
  const std::string name = indexed_name(key.name, index);
  const auto table = document.table_place.find(indexed_name(key.table(), index));
  const std::string& place = table == document.table_place.end() ? document.place : table->second;
  throw CaseError(name, fmt::format("{}: {} is missing (a {}: {}); write for example {} = {}", place, name,
                                    allowed_text(key), key.help, key.leaf(), example_text(key)));
}

/// The line along which the loads act: the sum of their horizontal forces, each with the sign that adds to the sum.
Numbers line_of_loads(const Case& c) {
  Numbers sum{0, 0};
  for (const Load& load : c.loads) {
    if (load.force.size() != 3) continue;  // refused by the checks
    const double sign = sum[0] * load.force[0] + sum[1] * load.force[1] < 0 ? -1 : 1;
    for (int d : {0, 1}) sum[d] += sign * load.force[d];
  }
  return sum[0] == 0 && sum[1] == 0 ? Numbers{1, 0} : sum;
}

/// Sets the values of the case's quality; the values of the file come after them.
void apply_quality(const Document& document, Case& c) {
  const auto chosen = document.entries.find("quality");
  if (chosen != document.entries.end()) find_key("quality")->bind.set(c, 0, chosen->second.value);
  for (const QualityValues& quality : qualities())
    if (quality.quality == c.quality)
      for (const QualityValue& value : quality.values) {
        const Key& key = *find_key(value.key);
        key.bind.set(c, 0, value_from_text(key, value.text));
      }
}

#ifdef SOFTWET_NO_REDUCED_QUADRATURE
constexpr bool has_reduced_points = false;
#else
constexpr bool has_reduced_points = true;
#endif
constexpr int explicit_history_every = 10;

/// Keys that are missing go to the problems, unless it is known already that they are wrong.
Case resolve(const Document& document, Problems& problems) {
  Case c;
  for (const Table& table : tables()) {
    for (std::size_t i = 0; i < entries_of(document, table.name); ++i) table.open(c, i);
  }
  apply_quality(document, c);
  for (const Key& key : schema()) {  // in schema order: the domain decides the dimension before the sides need it
    for (std::size_t i = 0; i < entries_of(document, key.table()); ++i) {
      const std::string name = indexed_name(key.name, i);
      const auto found = document.entries.find(name);
      if (found != document.entries.end()) key.bind.set(c, i, found->second.value);
      if (found == document.entries.end() && key.required && !problems.about(name))
        problems.keep([&] { reject_missing(document, key, i); });
    }
  }
  if (c.time.scheme == TimeScheme::automatic) {
    c.time.scheme = TimeScheme::generalized_alpha;
    c.time.automatic = true;
  }
  if (!document.entries.count("boundary.top")) {
    find_key("boundary.top")->bind.set(c, 0, std::string(c.fluid ? "no_slip" : "free"));
  }
  if (c.fluid && c.fluid->contact_angle_range.size() == 2 && !document.entries.count("fluid.contact_angle"))
    c.fluid->contact_angle = c.fluid->middle_of_range();
  if (c.substrate && !document.entries.count("substrate.surface_tension_wet"))
    c.substrate->surface_tension_wet = c.substrate->surface_tension;
  // Lines that begin to move or to stick need more iterations.
  if (c.fluid && c.fluid->resists_lines() && !document.entries.count("solver.newton.max")) c.solver.newton_max = 25;
  // Where the scheme hardly damps, what Newton's method leaves in the shortest waves adds up from step to step.
  if (c.time.rho_inf > 0.9 && !document.entries.count("solver.newton.rtol"))
    c.solver.newton_rtol = std::min(c.solver.newton_rtol, 1e-6);
  if (!c.time.implicit()) {  // what an explicit step costs, and what may be added to it
    if (!document.entries.count("domain.quadrature") && has_reduced_points) c.domain.quadrature = Quadrature::reduced;
    if (!document.entries.count("time.mass") && c.time.scheme == TimeScheme::rkl2) c.time.mass = MassKind::lumped;
    if (!document.entries.count("output.history.every")) c.output.history_every = explicit_history_every;
  }
  if (!c.domain.grading.lower.empty() && !document.entries.count("domain.grading.fine"))
    c.domain.grading.fine = FineElements::box;
  if (c.dimension() == 3 && !document.entries.count("output.history.track")) c.output.track = line_of_loads(c);
  return c;
}

/// Contact angles between which the wall law "gradient" works, in degrees: a line above the angles at which runs stop.
/// No closed criterion is known (docs/verification/wetting.md). Measured at temperature 0.39, fewer stop when warmer:
///   capillarity / h         1     2    3    4
///   stop at                28  15.5   13   12
///   stop at               157  none measured (172 works)
std::pair<double, double> gradient_law_angles(double h_over_capillarity) {
  return {8 + 22 * h_over_capillarity, 180 - std::max(0.0, 50 * h_over_capillarity - 25)};
}

/// A step ends at each point of a table over time.
void warn_of_long_tables(const Case& c, std::vector<std::string>& found) {
  constexpr long many = 2000;
  const auto look = [&](const std::string& key, const Profile& profile, double begin) {
    if (!profile.varies()) return;
    const std::vector<double> points = profile.formula->kinks();
    const long count =
        std::count_if(points.begin(), points.end(), [&](double t) { return t > begin && t < c.time.end; });
    if (count < many) return;
    found.push_back(
        fmt::format("{} is a table with {} points before time.end, and a step ends at each of them: fewer points allow "
                    "longer steps",
                    key, count));
  };
  for (std::size_t k = 0; k < c.loads.size(); ++k) {
    const double begin = c.loads[k].start - c.clock_zero();
    look(fmt::format("load[{}].factor", k), c.loads[k].factor, begin);
    for (const Profile& shift : c.loads[k].path) look(fmt::format("load[{}].path", k), shift, begin);
  }
  for (std::size_t k = 0; k < c.needles.size(); ++k)
    for (const Profile& shift : c.needles[k].path) look(fmt::format("needle[{}].path", k), shift, 0);
}

/// Numbers that are not those without them and change nothing, because what they belong to is not there.
void warn_of_idle_keys(const Case& c, std::vector<std::string>& found) {
  const auto tell = [&](bool idle, const std::string& key, const auto& value, const auto& usual,
                        const std::string& remedy) {
    if (idle && value != usual) found.push_back(fmt::format("{} = {} has no effect: {}", key, value, remedy));
  };
  if (c.fluid)
    tell(
        c.fluid->contact_angle_range.empty(), "fluid.creep_speed", c.fluid->creep_speed, Fluid{}.creep_speed,
        "without a fluid.contact_angle_range no contact line sticks; write for example contact_angle_range = [65, 85], "
        "two angles in [0, 180], or remove creep_speed");
  if (!c.substrate) return;
  const Substrate& s = *c.substrate;
  const std::string fibre =
      "without substrate.fibre.stiffness there are no fibres; write a stiffness above 0, or "
      "remove it";
  const std::string gel =
      "without substrate.gel.exponent the solid has no power law; write an exponent in (0, 1), or "
      "remove it";
  tell(s.fibre.stiffness == 0, "substrate.fibre.angle", s.fibre.angle, Fibre{}.angle, fibre);
  tell(s.fibre.stiffness == 0, "substrate.fibre.azimuth", s.fibre.azimuth, Fibre{}.azimuth, fibre);
  tell(!s.gel.acts(), "substrate.gel.time", s.gel.time, PowerLaw{}.time, gel);
  if (s.gel.decades != PowerLaw{}.decades && s.gel.decades.size() == 2)
    tell(!s.gel.acts(), "substrate.gel.decades", fmt::format("[{}, {}]", s.gel.decades[0], s.gel.decades[1]),
         std::string(), gel);
}

constexpr std::size_t largest_file = 16 << 20;  ///< bytes; of a case with a hundred thousand droplets

[[noreturn]] void reject_path(const std::string& path, const std::string& reason) {
  throw Error(Exit::invalid_input,
              fmt::format("cannot read the case file '{}': {}; give the path of a case, for example "
                          "cases/tensotaxis_pull_2d.toml",
                          path, reason));
}

/// A case file as it is read: its text with the assignments of the command line.
Document document_of(std::string_view text, const std::string& place, const std::vector<std::string>& overrides,
                     Problems& problems) {
  Document document = read_document(text, place, problems);
  for (const std::string& assignment : overrides)
    problems.keep([&] { apply_override(document, assignment, problems); });
  return document;
}

Case case_of_document(const Document& document, Problems& problems, Tables tables) {
  Case c = resolve(document, problems);
  if (c.initial && !c.initial->from.empty())  // the resolved case holds from any folder
    c.initial->from = std::filesystem::absolute(c.initial->from).lexically_normal().string();
  build_profiles(c, document, problems, tables);
  check_case(c, document, problems);
  problems.throw_if_any();
  choose_fine_box(c);
  return c;
}

Case parse(std::string_view text, const std::string& place, const std::vector<std::string>& overrides, Tables tables) {
  Problems problems;
  const Document document = document_of(text, place, overrides, problems);
  return case_of_document(document, problems, tables);
}

std::string text_of_file(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) reject_path(path, "it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) reject_path(path, std::strerror(errno));
  std::string text(largest_file + 1, '\0');  // a pipe or a device gives no size in advance
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) reject_path(path, std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > largest_file) reject_path(path, "it is longer than 16 MiB, which no case is");
  return text;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& place, const std::vector<std::string>& overrides) {
  return parse(text, place, overrides, Tables::read);
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  return parse(text_of_file(path), path, overrides, Tables::read);
}

LaboratoryCase read_laboratory_case(const std::string& path, const std::vector<std::string>& overrides,
                                    const Conversion& conversion) {
  Problems problems;
  Document document = document_of(text_of_file(path), path, overrides, problems);
  const std::optional<Laboratory> laboratory = follow_laboratory(document, conversion, problems);
  return {case_of_document(document, problems, Tables::read), laboratory};
}

Case read_scene(const std::string& path) { return parse(text_of_file(path), path, {}, Tables::leave); }

std::vector<std::string> warnings(const Case& c) {
  std::vector<std::string> found;
  if (c.fluid)
    if (const auto jump = jump_along_wall(c, c.fluid->contact_angle))
      found.push_back(
          fmt::format("fluid.contact_angle jumps by {:.3g} degrees at x = {:.4g}{}, which no mesh resolves: let it "
                      "change over a few "
                      "elements, for example with 60 + 30*step((x - 0.5)/h)",
                      std::abs(jump->height), jump->place[0],
                      c.dimension() == 3 ? fmt::format(", y = {:.4g}", jump->place[1]) : ""));
  warn_of_long_tables(c, found);
  warn_of_idle_keys(c, found);
  warn_of_stiff_parts(c, found);
  const double largest = c.spacing();
  if (c.fluid && c.fluid->capillarity < largest) {
    found.push_back(
        fmt::format("fluid.capillarity = {:.6g} is less than an element ({:.6g}): the liquid-vapour "
                    "interface is not resolved; use more elements or a capillarity of {:.6g} or more",
                    c.fluid->capillarity, largest, 2 * largest));
  }
  if (c.fluid && c.fluid->capillarity >= largest && c.fluid->wall_law == WallLaw::gradient) {
    const auto [least, most] = gradient_law_angles(largest / c.fluid->capillarity);
    const Profile& angle = c.fluid->contact_angle;
    if (angle.least() < least || angle.most() > most)
      found.push_back(fmt::format(
          "fluid.contact_angle = {:.6g} is outside [{:.3g}, {:.3g}], where fluid.wall_law = \"gradient\" was "
          "measured to work at temperature 0.39 with {:.3g} elements for a capillarity (softwet verify wetting): the "
          "density may leave its range at the contact line; write fluid.wall_law = \"energy\"",
          angle.least() < least ? angle.least() : angle.most(), least, most, c.fluid->capillarity / largest));
  }
  if (std::string what = warning_about_fine_box(c); !what.empty()) found.push_back(what);
  if (!c.output.field_times.empty() && c.output.field_times.back() > c.time.end) {
    found.push_back(fmt::format("output.fields.times beyond time.end = {} will not be written", c.time.end));
  }
  return found;
}

}  // namespace softwet
