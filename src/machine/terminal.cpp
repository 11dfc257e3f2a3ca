#include "machine/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <sstream>

namespace softwet {

bool speaks_to_terminal() { return isatty(STDERR_FILENO) != 0; }

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

std::string wrapped(const std::string& message, std::size_t width) {
  std::istringstream words(message);
  std::string text, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      text += line + "\n";
      line = "  " + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
  }
  return text + line;
}

std::string for_stderr(const std::string& message) {
  return speaks_to_terminal() ? wrapped(message, terminal_width()) : message;
}

}  // namespace softwet
