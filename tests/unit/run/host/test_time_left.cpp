// The time that is left, against runs whose steps are known beforehand.
#include "run/host/time_left.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace softwet {
namespace {

struct Ratio {
  double least = 1e300, largest = 0;
  int count = 0;
};

/// Runs from 0 to `end` with steps dt(time) of a second each, and compares every estimate with what came.
Ratio judge(double end, double dt_max, const std::function<double(double)>& dt) {
  std::vector<double> times{0};
  while (times.back() < end) times.push_back(std::min(end, times.back() + std::min(dt_max, dt(times.back()))));
  const long last = static_cast<long>(times.size()) - 1;
  TimeLeft left(end, dt_max, 1000000);
  Ratio ratio;
  for (long step = 1; step < last; ++step) {
    left.step(step, times[step], static_cast<double>(step));
    const auto seconds = left.seconds();
    if (!seconds || last - step < 3) continue;
    const double r = *seconds / static_cast<double>(last - step);
    ratio = {std::min(ratio.least, r), std::max(ratio.largest, r), ratio.count + 1};
  }
  return ratio;
}

TEST(TimeLeft, ConstantSteps) {
  const Ratio r = judge(100, 0.5, [](double) { return 0.5; });
  EXPECT_GT(r.count, 150);
  EXPECT_NEAR(r.least, 1, 0.02);
  EXPECT_NEAR(r.largest, 1, 0.02);
}

TEST(TimeLeft, StepsThatGrowOverDecades) {
  const Ratio r = judge(2000, 50, [](double t) { return 0.01 + 0.1 * t; });
  EXPECT_GT(r.count, 80);
  EXPECT_GT(r.least, 0.6);
  EXPECT_LT(r.largest, 1.6);
}

TEST(TimeLeft, StepsThatGrowSlowerOrFasterThanAssumed) {
  for (double power : {0.7, 1.3}) {
    const Ratio r = judge(2000, 50, [power](double t) { return 0.05 * std::pow(0.05 + t, power); });
    EXPECT_GT(r.least, 1.0 / 6) << power;
    EXPECT_LT(r.largest, 6) << power;
  }
}

TEST(TimeLeft, SaysNothingWhileStepsAreFew) {
  TimeLeft left(100, 1, 1000);
  for (long step = 1; step < 15; ++step) {
    left.step(step, 0.01 * static_cast<double>(step), static_cast<double>(step));
    EXPECT_FALSE(left.seconds()) << step;
  }
}

TEST(TimeLeft, AResumedRunKnowsAfterThreeSteps) {
  TimeLeft left(100, 1, 1000);
  left.step(501, 50, 1);
  left.step(502, 51, 3);
  EXPECT_FALSE(left.seconds());
  left.step(503, 52, 5);
  EXPECT_NEAR(left.seconds().value(), 2 * 48, 1e-9);
}

TEST(TimeLeft, TheNumberOfStepsMayEndTheRun) {
  TimeLeft left(1e6, 1, 110);
  for (long step = 95; step <= 100; ++step) left.step(step, static_cast<double>(step), 2 * static_cast<double>(step));
  EXPECT_NEAR(left.seconds().value(), 20, 1e-9);
}

TEST(TimeLeft, RoughDurations) {
  EXPECT_EQ(rough_duration(0), "a few seconds");
  EXPECT_EQ(rough_duration(42), "about 40 s");
  EXPECT_EQ(rough_duration(94), "about 90 s");
  EXPECT_EQ(rough_duration(190), "about 3 min");
  EXPECT_EQ(rough_duration(1900), "about 30 min");
  EXPECT_EQ(rough_duration(3500), "about 1 h");
  EXPECT_EQ(rough_duration(5500), "about 1.5 h");
  EXPECT_EQ(rough_duration(4e5), "about 5 days");
}

}  // namespace
}  // namespace softwet
