// A value of a case file, free of any TOML library: how it is read from text, shown to people and written back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace softwet {

using Numbers = std::vector<double>;

using Words = std::vector<std::string>;

/// Number or integer | text or choice | list of numbers | box (two corners) | list of names.
using Value = std::variant<double, std::string, Numbers, std::vector<Numbers>, Words>;

/// A number as papers write it, "0.39", "-2e-3" or a ratio "1/256", or as TOML does, "1_000". Nothing when the text is
/// anything else. Zero has no sign: -0.0 is 0, as for all values of a case.
std::optional<double> number_from_text(std::string_view text);

/// "first:last:count", numbers at equal distances with both ends: "0:5:11" is 0, 0.5, ..., 5. Count is 2 to 10000.
std::optional<Numbers> range_from_text(std::string_view text);

/// Shortest text that reads back to the same number.
std::string text_of_number(double number);

/// TOML text of a value: 0.39, "slip", [1, 0.5], [[0.7, 0], [0.8, 0.125]].
std::string text_of_value(const Value& value);

/// TOML string with quotes, backslashes and control characters escaped.
std::string in_quotes(std::string_view text);

}  // namespace softwet
