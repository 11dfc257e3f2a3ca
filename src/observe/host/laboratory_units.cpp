#include "observe/host/laboratory_units.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <sstream>

#include "io/run_record.hpp"
#include "observe/host/probe_quantity.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// Powers of a, b and L0 in a unit of a case; of m, s and kg in a unit of SI.
using Powers = std::array<double, 3>;

struct Factor {
  const char* name;
  Powers powers;
};
constexpr Factor factors[]{{"sqrt(ab)", {0.5, 0.5, 0}}, {"ab", {1, 1, 0}}, {"a", {1, 0, 0}}, {"b", {0, 1, 0}},
                           {"L0", {0, 0, 1}},           {"1", {0, 0, 0}}};

/// The power of "L0^d", "L0^(d-1)", "b^2" and "a".
std::optional<double> power_in(const std::string& text, int dimension) {
  if (text.empty()) return 1;
  if (text == "^d") return dimension;
  if (text == "^(d-1)") return dimension - 1;
  const bool digit = text.size() == 2 && text[0] == '^' && text[1] >= '0' && text[1] <= '9';
  return digit ? std::optional<double>(text[1] - '0') : std::nullopt;
}

/// Adds the powers of "a", "b^2" or "L0^d", times `sign`. @return whether it is such a factor
bool add_factor(const std::string& text, int dimension, double sign, Powers& sum) {
  for (const Factor& factor : factors) {
    const std::string name = factor.name;
    if (text.compare(0, name.size(), name) != 0) continue;
    const auto power = power_in(text.substr(name.size()), dimension);
    if (!power) continue;
    for (int i = 0; i < 3; ++i) sum[i] += sign * *power * factor.powers[i];
    return true;
  }
  return false;
}

/// Factors stand between blanks; all behind a stroke are below it.
std::optional<Powers> powers_of(const std::string& unit, int dimension) {
  Powers sum{};
  double sign = 1;
  std::istringstream parts(unit);
  if (unit.empty()) return {};
  for (std::string part; std::getline(parts, part, '/'); sign = -1) {
    std::istringstream words(part);
    for (std::string word; words >> word;)
      if (!add_factor(word, dimension, sign, sum)) return {};
  }
  return sum;
}

/// Units by their powers of m, s and kg; energies and powers of a scene in 2D are per depth.
struct UnitOfSi {
  Powers powers;
  const char* name;
  double si;
};
constexpr UnitOfSi named_units[]{{{1, 0, 0}, "um", 1e-6},    {{2, 0, 0}, "um^2", 1e-12},   {{3, 0, 0}, "nl", 1e-12},
                                 {{0, 1, 0}, "ms", 1e-3},    {{1, -1, 0}, "mm/s", 1e-3},   {{-1, -2, 1}, "kPa", 1e3},
                                 {{0, -2, 1}, "mN/m", 1e-3}, {{-1, -1, 1}, "mPa.s", 1e-3}, {{-3, 0, 1}, "kg/m3", 1},
                                 {{2, -2, 1}, "nJ", 1e-9},   {{1, -2, 1}, "uN", 1e-6},     {{2, -3, 1}, "uW", 1e-6},
                                 {{1, -3, 1}, "mW/m", 1e-3}, {{1, -2, 0}, "m/s^2", 1},     {{2, -2, 0}, "J/kg", 1},
                                 {{0, 0, 1}, "ug", 1e-9},    {{-1, 0, 1}, "mg/m", 1e-6}};

/// "m^2 s^-3", for units without a name of their own.
std::string name_of(const Powers& powers) {
  std::string text;
  constexpr const char* names[]{"m", "s", "kg"};
  for (int i = 0; i < 3; ++i)
    if (powers[i] != 0)
      text +=
          (text.empty() ? "" : " ") + std::string(names[i]) + (powers[i] == 1 ? "" : fmt::format("^{:g}", powers[i]));
  return text;
}

RecordValue record_of(const ShownUnit& unit) {
  RecordValue record;
  record["unit"] = unit.name;
  record["factor"] = unit.factor;
  return record;
}

}  // namespace

std::optional<ShownUnit> shown_unit(const std::string& unit, int dimension, const Scales& scales) {
  const auto powers = powers_of(unit, dimension);
  if (!powers || *powers == Powers{}) return {};
  const auto [a, b, length] = *powers;  // a in m^5/(kg s^2), b in kg/m^3
  const Powers si{5 * a - 3 * b + length, -2 * a, b - a};
  const double value = std::pow(scales.a, a) * std::pow(scales.density, b) * std::pow(scales.length, length);
  for (const UnitOfSi& named : named_units)
    if (named.powers == si) return ShownUnit{named.name, value / named.si};
  return ShownUnit{name_of(si), value};
}

std::string units_record(const Case& c, const Scales& scales) {
  RecordValue root;
  RecordValue& one = root["one_unit_in_si"];
  one["length"] = scales.length;
  one["time"] = scales.time();
  one["density"] = scales.density;
  one["stress"] = scales.stress();
  const int dimension = dimension_of_units(c);
  for (const ColumnTable& table : column_tables())
    for (const Column& column : table.columns)
      if (const auto unit = shown_unit(column.unit, dimension, scales))
        root[table.name][column.name] = record_of(*unit);
  for (const Probe& probe : c.probes)
    if (const auto unit = shown_unit(probe_quantity(probe.quantity).field->unit, dimension, scales))
      root["history"][probe.name] = record_of(*unit);
  return root.json() + "\n";
}

}  // namespace softwet
