// Units of measurement.
#include "casefile/schema/quantity.hpp"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "case/error.hpp"
#include "casefile/schema/value.hpp"

namespace softwet {
namespace {

struct Unit {
  const char* name;
  double si;
};

const std::vector<Unit>& units_of(Quantity quantity) {
  static const std::vector<Unit> length{{"nm", 1e-9}, {"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}},
      tension{{"mN/m", 1e-3}, {"N/m", 1}}, density{{"kg/m3", 1}, {"g/cm3", 1000}},
      viscosity{{"mPa.s", 1e-3}, {"Pa.s", 1}}, stress{{"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"Pa", 1}};
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

}  // namespace

double si_from_text(const std::string& name, Quantity quantity, const std::string& text) {
  const std::string digits = text.substr(0, text.find_first_not_of("0123456789.+-eE "));
  const std::string rest = text.substr(digits.size());
  std::string names;
  for (const Unit& unit : units_of(quantity)) {
    const auto number = number_from_text(digits);
    if (rest == unit.name && number && std::isfinite(*number) && *number > 0) return *number * unit.si;
    names += (names.empty() ? "" : ", ") + std::string(unit.name);
  }
  throw Error(Exit::invalid_input,
              fmt::format("{} = {}: must be a number above 0 with one of the units {}; write for example {} 1{}", name,
                          text, names, name, units_of(quantity).front().name));
}

}  // namespace softwet
