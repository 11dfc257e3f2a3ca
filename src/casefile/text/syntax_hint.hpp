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

/// A list as TOML takes it from one whose expressions have no quotes: [0.05*t, 0] -> ["0.05*t", 0]. None where the text
/// is no list, holds quotes or lists, or has no expression.
std::optional<std::string> with_quoted_expressions(std::string_view list);

}  // namespace softwet
