// Texts as JSON writes them.
#pragma once

#include <string>

namespace softwet {

/// The text in quotes, escaped; bytes that are not UTF-8 become the replacement character U+FFFD.
std::string json_string(const std::string& text);

}  // namespace softwet
