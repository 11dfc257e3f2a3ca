#include "run/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "run/host/time_left.hpp"

namespace softwet {
namespace {

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// Characters in a row of the terminal; a longer line would not be rewritten but pile up.
std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

}  // namespace

Progress::Voice Progress::voice(bool quiet) {
  if (quiet) return Voice::silent;
  return isatty(STDERR_FILENO) ? Voice::terminal : Voice::lines;
}

void Progress::step(double t, long step, double dt, const Headline& headline,
                    const std::optional<double>& seconds_left) {
  if (voice_ == Voice::silent) return;
  const auto pause = voice_ == Voice::terminal ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10000);
  if (Clock::now() - last_ < pause) return;
  last_ = Clock::now();
  const double share = std::clamp((t - start_) / std::max(end_ - start_, 1e-300), 0.0, 1.0);
  std::string line = text("t = %.6g", t) + text(" of %.6g", end_) + text(" (%.0f %%)", 100 * share);
  if (seconds_left) line += ", " + rough_duration(*seconds_left) + " left";
  line += ", step " + std::to_string(step) + text(", dt = %.3g", dt);
  for (std::size_t d = 0; d < headline.centre.size(); ++d)
    line += text(d == 0 ? ", x = %.4f" : ", y = %.4f", headline.centre[d]);
  if (headline.velocity) line += text(", V = %.2e", *headline.velocity);
  if (headline.mass_drift) line += text(", mass drift %+.0e", *headline.mass_drift);
  if (voice_ == Voice::terminal) {
    std::fprintf(stderr, "\r%s\033[K", line.substr(0, terminal_width() - 1).c_str());
    open_line_ = true;
  } else {
    std::fprintf(stderr, "%s\n", line.c_str());
  }
  std::fflush(stderr);
}

void Progress::tell(const std::string& message) {
  if (voice_ == Voice::silent) return;
  finish_line();
  std::fprintf(stderr, "softwet: %s\n", message.c_str());
}

void Progress::finish_line() {
  if (open_line_) std::fprintf(stderr, "\n");
  open_line_ = false;
}

}  // namespace softwet
