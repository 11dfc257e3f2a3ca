#include "run/host/results.hpp"

#include <fmt/core.h>

#include "observe/host/laboratory_units.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// Words about some columns of a row, which name those that exist.
class Line {
 public:
  Line(const TableRow& row, int dimension, const std::optional<Scales>& laboratory)
      : row_(row), dimension_(dimension), laboratory_(laboratory) {}

  /// Adds "LABEL NUMBER", and with `unit` the unit of the column.
  Line& add(const std::string& label, const std::string& column, bool unit = false, int digits = 5) {
    const auto shown = number_of(column);
    if (!shown) return *this;
    text_ += fmt::format("{}{} {:.{}g}", text_.empty() ? "" : ", ", label, shown->factor, digits);
    if (unit) text_ += behind(*shown);
    return *this;
  }
  /// Both sides of something where both exist, or the one that does.
  Line& add_pair(const std::string& first, const std::string& second, const char* between) {
    const auto a = number_of(first), b = number_of(second);
    if (!a && !b) return *this;
    text_ += text_.empty() ? "" : ", ";
    text_ += a && b ? fmt::format("{:.5g} {} {:.5g}", a->factor, between, b->factor)
                    : fmt::format("{:.5g}", (a ? a : b)->factor);
    text_ += behind(a ? *a : *b);
    return *this;
  }
  void put(const char* title, std::vector<std::string>& lines) const {
    if (!text_.empty()) lines.push_back(fmt::format("  {:<13} {}", title, text_));
  }

 private:
  /// The number of a cell, as so much of the unit in which it is shown.
  std::optional<ShownUnit> number_of(const std::string& column) const {
    const TableRow::Cell cell = row_.cell(column);
    if (!cell) return {};
    std::string unit = history_column(column).unit;
    const auto shown = laboratory_ ? shown_unit(unit, dimension_, *laboratory_) : std::nullopt;
    if (shown) return ShownUnit{shown->name, *cell * shown->factor};
    if (const auto d = unit.find("^d"); d != std::string::npos) unit.replace(d, 2, "^" + std::to_string(dimension_));
    return ShownUnit{unit, *cell};
  }
  static std::string behind(const ShownUnit& shown) { return shown.name.empty() ? "" : " " + shown.name; }

  const TableRow& row_;
  int dimension_;
  const std::optional<Scales>& laboratory_;
  std::string text_;
};

}  // namespace

std::vector<std::string> result_lines(const Case& c, const TableRow& row, const std::optional<Scales>& laboratory) {
  const bool plane = c.dimension() == 2;
  const std::string left = plane ? "left" : "rear", right = plane ? "right" : "front";
  const auto line = [&] { return Line(row, dimension_of_units(c), laboratory); };
  std::vector<std::string> lines;
  Line place = line();
  place.add("x =", "x_centre", plane);
  if (!plane) place.add("y =", "y_centre", true);
  place.add("velocity", "velocity", true, 3).put("droplet", lines);
  if (plane)
    line().add_pair("x_left", "x_right", "to").put("contact line", lines);
  else
    line().add("area", "contact_area", true).put("contact line", lines);
  line().add_pair("angle_" + left, "angle_" + right, "and").put("angles", lines);
  line().add_pair("ridge_" + left, "ridge_" + right, "and").add("dimple", "dimple", true).put("ridge", lines);
  line().add("volume", "liquid_volume", true).add("mass drift", "mass_drift").put("liquid", lines);
  line().add("total", "energy_total", true).add("elastic", "energy_elastic").put("energy", lines);
  line().add("fluid", "speed_max_fluid").add("solid", "speed_max_solid", true).put("speeds", lines);
  if (const std::size_t more = c.droplets.size(); more > 1)
    lines.push_back(fmt::format("  {:<13} {} more in history.csv", "droplets", more - 1));
  return lines;
}

std::vector<std::string> next_lines(const Case& c, const std::string& folder, bool fields) {
  std::vector<std::string> lines{fmt::format("  {:<13} tools/report {}", "next:", folder)};
  if (fields)
    lines.push_back(
        fmt::format("  {:<13} {}/fields/{}.hdf.series", "in ParaView:", folder, c.substrate ? "solid" : "fluid"));
  return lines;
}

}  // namespace softwet
