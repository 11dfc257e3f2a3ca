// The terminal that messages go to.
#pragma once

#include <cstddef>
#include <string>

namespace softwet {

/// Whether stderr is a terminal.
bool speaks_to_terminal();

/// Characters in a row of the terminal of stderr; 80 where it is none.
std::size_t terminal_width();

/// A message in lines of at most `width` characters, broken between words; those behind the first one begin with two
/// blanks. A longer word has a line of its own.
std::string wrapped(const std::string& message, std::size_t width);

/// For stderr: wrapped where it is a terminal, and else as it is, for programs that read it line by line.
std::string for_stderr(const std::string& message);

}  // namespace softwet
