#include "run/progress.hpp"

#include <algorithm>
#include <cstdio>

#include "case/text.hpp"
#include "machine/terminal.hpp"
#include "run/host/time_left.hpp"

namespace softwet {

Progress::Voice Progress::voice() { return speaks_to_terminal() ? Voice::terminal : Voice::lines; }

void Progress::step(double t, long step, double dt, const TableRow& row, const std::optional<double>& seconds_left) {
  if (!is_due()) return;
  const double share = std::clamp((t - start_) / std::max(end_ - start_, 1e-300), 0.0, 1.0);
  std::string line = formatted(t, "t = %.6g") + formatted(end_, " of %.6g") + formatted(100 * share, " (%.0f %%)");
  if (seconds_left) line += ", " + rough_duration(*seconds_left) + " left";
  for (const auto& [column, format] :
       {std::pair{"x_centre", ", x_centre %.4f"}, std::pair{"y_centre", ", y_centre %.4f"},
        std::pair{"velocity", ", velocity %.1e"}})
    if (const TableRow::Cell cell = row.cell(column)) line += formatted(*cell, format);
  line += ", step " + std::to_string(step) + formatted(dt, ", dt = %.3g");
  if (const TableRow::Cell cell = row.cell("mass_drift")) line += formatted(*cell, ", mass_drift %+.0e");
  show(line);
}

void Progress::settle(long step, double change) {
  if (!is_due()) return;
  show("on its way to rest: step " + std::to_string(step) + formatted(change, ", the fields change by %.2g") +
       " of their range in a unit of time");
}

bool Progress::is_due() {
  if (voice_ == Voice::silent) return false;
  const auto pause = voice_ == Voice::terminal ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10000);
  if (Clock::now() - last_ < pause) return false;
  last_ = Clock::now();
  return true;
}

void Progress::show(const std::string& line) {
  if (voice_ == Voice::terminal) {
    // A line longer than the terminal would not be rewritten but pile up.
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
  std::fprintf(stderr, "%s\n", for_stderr("softwet: " + message).c_str());
}

void Progress::add(const std::string& line) {
  if (voice_ != Voice::silent) std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::finish_line() {
  if (open_line_) std::fprintf(stderr, "\n");
  open_line_ = false;
}

}  // namespace softwet
