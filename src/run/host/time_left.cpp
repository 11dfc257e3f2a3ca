#include "run/host/time_left.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

constexpr std::size_t window = 5;  // steps whose mean size and duration count
constexpr long fewest_steps = 15;  // before that, steps have not yet begun to grow

double rounded(double value, double unit) { return std::max(1.0, std::round(value / unit)) * unit; }

}  // namespace

void TimeLeft::step(long step, double time, double seconds) {
  recent_.push_back({step, time, seconds});
  if (recent_.size() > window + 1) recent_.pop_front();
}

std::optional<double> TimeLeft::seconds() const {
  if (recent_.size() < 3 || recent_.back().step < fewest_steps) return std::nullopt;
  const Sample &first = recent_.front(), &last = recent_.back();
  const auto steps = static_cast<double>(last.step - first.step);
  const double dt = (last.time - first.time) / steps, time = last.time;
  if (!(dt > 0) || !(time > 0)) return std::nullopt;
  const double largest = std::max(dt, dt_max_);
  const double until = std::clamp(time * largest / dt, time, std::max(time, end_));  // steps grow up to this time
  const double growing = time / dt * std::log(until / time), largest_ones = std::max(0.0, end_ - until) / largest;
  const double left = std::min(growing + largest_ones, static_cast<double>(max_steps_ - last.step));
  return std::max(0.0, left) * (last.seconds - first.seconds) / steps;
}

std::string rough_duration(double seconds) {
  if (seconds < 10) return "a few seconds";
  if (seconds < 95) return fmt::format("about {:g} s", rounded(seconds, 10));
  const double minutes = seconds / 60, hours = minutes / 60;
  if (minutes < 57) return fmt::format("about {:g} min", rounded(minutes, minutes < 10 ? 1 : 5));
  if (hours < 36) return fmt::format("about {:g} h", rounded(hours, hours < 5 ? 0.5 : 1));
  return fmt::format("about {:g} days", rounded(hours / 24, 1));
}

}  // namespace softwet
