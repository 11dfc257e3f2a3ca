#include "time/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace softwet {

StepControl::StepControl(const StepLimits& limits, std::vector<double> events)
    : limits_(limits), events_(std::move(events)), proposed_(limits.initial) {
  std::sort(events_.begin(), events_.end());
  const auto same = [](double a, double b) { return b - a <= 1e-9 * std::max(1.0, std::abs(b)); };  // as same_time
  events_.erase(std::unique(events_.begin(), events_.end(), same), events_.end());
}

double StepControl::next(double t, double largest, double jump) const {
  constexpr double rounding = 1e-9;  // of the sum of many equal steps
  const double wish = std::min(proposed_, largest);
  const double tiny = 1e-12 * std::max(1.0, std::abs(t));
  const auto listed = std::upper_bound(events_.begin(), events_.end(), t + tiny);
  const double event = listed == events_.end() ? jump : std::min(*listed, jump);
  if (!std::isfinite(event)) return wish;
  double left = event - t;
  if (t + left > event) left = std::nextafter(left, 0.0);
  if (left <= std::min(stretch * wish, (1 + rounding) * std::min(limits_.largest, largest))) return left;
  return left < 2 * wish ? 0.5 * left : wish;
}

double StepControl::allowed(double dt) const {
  constexpr double least = 0.25;
  return limits_.tolerance * std::clamp(limits_.slow / dt, least, 1.0);
}

void StepControl::accept(double dt, double indicator, Effort effort) {
  double factor = indicator > 0 ? 0.9 * std::sqrt(allowed(dt) / indicator) : 2.0;
  factor = std::clamp(factor, 0.5, 1.5);
  if (effort == Effort::laborious) factor = std::min(factor, 0.9);
  // A step cut short to meet an event says little about a longer one: never fall below the old proposal for that.
  const double wish = dt < 0.7 * proposed_ && factor > 1 ? std::max(proposed_, factor * dt) : factor * dt;
  proposed_ = std::clamp(wish, limits_.smallest, limits_.largest);
}

bool StepControl::reject(double dt) {
  proposed_ = 0.5 * dt;
  return proposed_ >= limits_.smallest;
}

}  // namespace softwet
