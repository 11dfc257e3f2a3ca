// Numbers in sentences for the user. Numbers in files are exact: io/number_text.
#pragma once

#include <cstdio>
#include <string>

namespace softwet {

/// A number by a format of printf for one double, "%.3g".
inline std::string formatted(double value, const char* format) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// A number with few significant digits: "0.155", "1e-05".
inline std::string short_text(double value, int digits = 3) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace softwet
