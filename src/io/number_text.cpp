#include "io/number_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace softwet {

std::string number_text(double value) {
  constexpr double exact_integers = 9007199254740992.0;  // 2^53
  if (std::abs(value) < exact_integers && value == std::trunc(value)) {
    return std::to_string(static_cast<std::int64_t>(value));
  }
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

}  // namespace softwet
