// Lines that are no TOML although their meaning is clear: a ratio without quotes, a decimal comma, a unit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace softwet {

/// What is wrong with a line of a case file, as parts of a message.
struct SyntaxHint {
  std::string key;  ///< indexed name, "load[0].ramp"
  std::string value, problem, remedy;
};

/// @param line  counted from 1
/// @return      nothing where the line is none of the mistakes known here
std::optional<SyntaxHint> syntax_hint(std::string_view text, long line);

}  // namespace softwet
