#include "io/output_time.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

constexpr double few_units = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

double short_decimal(double value, double rounding) {
  if (std::abs(value) <= rounding) return 0;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 11).ptr;
  double rounded = value;
  std::from_chars(text, end, rounded);
  return std::abs(rounded - value) <= rounding ? rounded : value;
}

double short_decimal(double value) { return short_decimal(value, few_units * std::abs(value)); }

double output_time(double time, double zero) {
  return short_decimal(time - zero, few_units * std::max(std::abs(time), std::abs(zero)));
}

}  // namespace softwet
