#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace softwet {
namespace {

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string duration_text(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s < 100) return std::to_string(s) + " s";
  if (s < 6000) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s / 60 % 60) + " min";
}

}  // namespace

Progress::Voice Progress::voice(bool quiet) {
  if (quiet) return Voice::silent;
  return isatty(STDERR_FILENO) ? Voice::terminal : Voice::lines;
}

Progress::Progress(Voice voice, double start, double end)
    : voice_(voice), start_(start), end_(end), begin_(Clock::now()), last_(begin_), recent_{{begin_, start}} {}

std::string Progress::time_left(double t) {
  const Clock::time_point now = Clock::now();
  recent_.emplace_back(now, t);
  while (recent_.size() > 2 && now - recent_[1].first > std::chrono::seconds(20)) recent_.pop_front();
  const double wall = std::chrono::duration<double>(now - recent_.front().first).count();
  const double advance = t - recent_.front().second;
  const bool early = now - begin_ < std::chrono::seconds(5) || t - start_ < 0.01 * (end_ - start_);  // steps still grow
  return advance > 0 && !early ? duration_text((end_ - t) * wall / advance) + " left" : "";
}

void Progress::step(double t, long step, const StepReport& report, const Headline& headline) {
  if (voice_ == Voice::silent) return;
  const std::string left = time_left(t);
  const auto pause = voice_ == Voice::terminal ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10000);
  if (Clock::now() - last_ < pause) return;
  last_ = Clock::now();
  std::string line = text("t %.6g", t) + text("  dt %.3g", report.dt) + "  step " + std::to_string(step) + "  Newton " +
                     std::to_string(report.newton) + " Krylov " + std::to_string(report.krylov);
  for (std::size_t d = 0; d < headline.centre.size(); ++d)
    line += text(d == 0 ? "  x %.4f" : "  y %.4f", headline.centre[d]);
  if (headline.velocity) line += text("  V %.2e", *headline.velocity);
  if (headline.mass_drift) line += text("  mass %+.0e", *headline.mass_drift);
  line += text("  %.0f %%  ", 100 * std::clamp((t - start_) / std::max(end_ - start_, 1e-300), 0.0, 1.0)) + left;
  if (voice_ == Voice::terminal) {
    std::fprintf(stderr, "\r%s\033[K", line.c_str());
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
