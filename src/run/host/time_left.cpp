#include "run/host/time_left.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

constexpr std::size_t window = 5;  // steps whose mean size counts
constexpr long fewest_steps = 15;  // before that, steps have not yet begun to grow
constexpr std::size_t most = 256;  // samples of the whole run
constexpr std::size_t begin = 2;   // the sample that the first doubling of the time begins with

double rounded(double value, double unit) { return std::max(1.0, std::round(value / unit)) * unit; }

/// Steps from `time` to `end` whose size is dt now, grows with the power 3/2 of the time, and stays at `largest`.
double growing_steps(double time, double end, double dt, double largest) {
  const double until = std::clamp(time * std::pow(largest / dt, 2.0 / 3), time, std::max(time, end));
  return 2 * time / dt * (1 - std::sqrt(time / until)) + std::max(0.0, end - until) / largest;
}

}  // namespace

void TimeLeft::step(long step, double time, double seconds) {
  const Sample sample{step, time, seconds};
  recent_.push_back(sample);
  if (recent_.size() > window + 1) recent_.pop_front();
  if (seen_++ % stride_ == 0) remember(sample);
}

void TimeLeft::remember(const Sample& sample) {
  all_.push_back(sample);
  if (all_.size() < most) return;
  for (std::size_t i = begin + 1; 2 * i - begin < all_.size(); ++i) all_[i] = all_[2 * i - begin];
  all_.resize((all_.size() + begin + 1) / 2);
  stride_ *= 2;
}

double TimeLeft::seconds_of_a_step() const {
  const Sample& last = recent_.back();
  const Sample *from = &recent_.front(), *half = &all_[all_.size() / 2];
  if (half->step < from->step) from = half;
  return (last.seconds - from->seconds) / static_cast<double>(last.step - from->step);
}

double TimeLeft::as_so_far() const {
  const Sample &first = all_[std::min(begin, all_.size() - 1)], &last = recent_.back();
  const double doublings = std::log(last.time / first.time);
  return doublings > 0 ? (last.seconds - first.seconds) / doublings * std::log(end_ / last.time) : 0;
}

std::optional<double> TimeLeft::seconds() const {
  if (recent_.size() < 3 || recent_.back().step < fewest_steps) return std::nullopt;
  const Sample &first = recent_.front(), &last = recent_.back();
  const double dt = (last.time - first.time) / static_cast<double>(last.step - first.step);
  if (!(dt > 0) || !(last.time > 0)) return std::nullopt;
  const double each = seconds_of_a_step(), largest = std::max(dt, dt_max_), time = std::max(0.0, end_ - last.time);
  double left = time / dt * each;
  if (follow_ == StepsFollow::error && time > 0)
    left = std::sqrt(std::clamp(as_so_far(), time / largest * each, left) *
                     growing_steps(last.time, end_, dt, largest) * each);
  return std::max(0.0, std::min(left, static_cast<double>(max_steps_ - last.step) * each));
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
