// Units of measurement.
#include "casefile/schema/quantity.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

#include "case/error.hpp"
#include "casefile/schema/value.hpp"

namespace softwet {
namespace {

struct Unit {
  const char* name;
  double si;
};

constexpr std::pair<Quantity, const char*> quantity_names[]{{Quantity::length, "a length"},
                                                            {Quantity::surface_tension, "a surface tension"},
                                                            {Quantity::density, "a density"},
                                                            {Quantity::viscosity, "a viscosity"},
                                                            {Quantity::stress, "a stress"}};

const std::vector<Unit>& units_of(Quantity quantity) {
  static const std::vector<Unit> length{{"nm", 1e-9}, {"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}},
      tension{{"mN/m", 1e-3}, {"N/m", 1}, {"dyn/cm", 1e-3}}, density{{"kg/m3", 1}, {"g/cm3", 1000}, {"g/ml", 1000}},
      viscosity{{"mPa.s", 1e-3}, {"Pa.s", 1}, {"cP", 1e-3}, {"P", 0.1}},
      stress{{"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"Pa", 1}};
  switch (quantity) {
    case Quantity::length:
      return length;
    case Quantity::surface_tension:
      return tension;
    case Quantity::density:
      return density;
    case Quantity::viscosity:
      return viscosity;
    default:
      return stress;
  }
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// A unit without what people write differently: spaces, dots, powers, and both Greek letters of micro.
std::string plain_unit(std::string text) {
  for (const char* micro : {"\u00b5", "\u03bc"}) replace_all(text, micro, "u");
  for (const char* nothing : {" ", "^", ".", "*", "\u00b7", "\u22c5"}) replace_all(text, nothing, "");
  replace_all(text, "\u00b3", "3");
  return text;
}

}  // namespace

std::optional<double> si_from(Quantity quantity, const std::string& text) {
  const std::string digits = text.substr(0, text.find_first_not_of("0123456789.+-eE "));
  const std::string rest = plain_unit(text.substr(digits.size()));
  const auto number = number_from_text(digits);
  if (!number || !std::isfinite(*number) || *number <= 0) return {};
  for (const Unit& unit : units_of(quantity))
    if (rest == plain_unit(unit.name)) return *number * unit.si;
  return {};
}

std::string problem_with(Quantity quantity, const std::string& text) {
  std::string names;
  for (const Unit& unit : units_of(quantity)) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  std::string other;
  for (const auto& [candidate, name] : quantity_names)
    if (candidate != quantity && si_from(candidate, text)) other = fmt::format(", and this is {}", name);
  return fmt::format("must be a number above 0 with one of the units {}{}", names, other);
}

double si_from_text(const std::string& name, Quantity quantity, const std::string& text) {
  if (const auto si = si_from(quantity, text)) return *si;
  throw Error(Exit::invalid_input, fmt::format("{} = {}: {}; write for example {} 1{}", name, text,
                                               problem_with(quantity, text), name, units_of(quantity).front().name));
}

}  // namespace softwet
