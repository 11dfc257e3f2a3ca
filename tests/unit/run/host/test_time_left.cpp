// The time that is left, against runs whose steps are known beforehand.
#include "run/host/time_left.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

#include "unit/run/host/recorded_runs.hpp"

namespace softwet {
namespace {

struct Ratio {
  double least = 1e300, largest = 0;
  int count = 0;
};

/// Runs from 0 to `end` with steps dt(time) of a second each, and compares the estimates of the second half with what came.
Ratio judge(double end, double dt_max, const std::function<double(double)>& dt) {
  std::vector<double> times{0};
  while (times.back() < end) times.push_back(std::min(end, times.back() + std::min(dt_max, dt(times.back()))));
  const long last = static_cast<long>(times.size()) - 1;
  TimeLeft left(end, dt_max, 1000000);
  Ratio ratio;
  for (long step = 1; step < last; ++step) {
    left.step(step, times[step], static_cast<double>(step));
    const auto seconds = left.seconds();
    if (!seconds || 2 * step < last || last - step < 3) continue;
    const double r = *seconds / static_cast<double>(last - step);
    ratio = {std::min(ratio.least, r), std::max(ratio.largest, r), ratio.count + 1};
  }
  return ratio;
}

/// From half of a run's seconds to nine tenths. What is left then is a few seconds of a run of a minute.
Ratio judge(const RecordedRun& run) {
  struct Step {
    long number;
    double time, seconds;
  };
  std::vector<Step> steps;
  std::istringstream text(run.steps);
  char comma = 0;
  for (Step s{}; text >> s.number >> s.time >> s.seconds; text >> comma) steps.push_back(s);
  const double all = steps.back().seconds;
  TimeLeft left(run.end, run.dt_max, 1000000, run.follow);
  Ratio ratio;
  for (const Step& s : steps) {
    left.step(s.number, s.time, s.seconds);
    const auto seconds = left.seconds();
    if (!seconds || s.seconds < 0.5 * all || s.seconds > 0.9 * all) continue;
    const double r = *seconds / (all - s.seconds);
    ratio = {std::min(ratio.least, r), std::max(ratio.largest, r), ratio.count + 1};
  }
  return ratio;
}

TEST(TimeLeft, TheSecondHalfOfTenCases) {
  for (const RecordedRun& run : recorded_runs) {
    const Ratio r = judge(run);
    EXPECT_GE(r.count, 10) << run.name;
    EXPECT_GT(r.least, 1 / 1.5) << run.name;
    EXPECT_LT(r.largest, 1.5) << run.name;
  }
}

TEST(TimeLeft, StepsBoundByStability) {
  TimeLeft left(100, 50, 1000000, StepsFollow::stability);
  for (long step = 1; step <= 20; ++step)
    left.step(step, 0.1 * static_cast<double>(step), 3 * static_cast<double>(step));
  EXPECT_NEAR(left.seconds().value(), 3 * 980, 1e-6);
}

/// 128 steps and more of a long run are kept, so that half of the steps is known to 1 in 128.
TEST(TimeLeft, AHundredThousandSteps) {
  TimeLeft left(20000, 50, 100000000, StepsFollow::stability);
  for (long step = 1; step <= 100000; ++step)  // the first half of the steps took twice as long
    left.step(step, 0.1 * static_cast<double>(step), static_cast<double>(step < 50000 ? 2 * step : step + 50000));
  EXPECT_NEAR(left.seconds().value(), 100000, 1600);
}

TEST(TimeLeft, ConstantSteps) {
  const Ratio r = judge(100, 0.5, [](double) { return 0.5; });
  EXPECT_GT(r.count, 90);
  EXPECT_NEAR(r.least, 1, 0.02);
  EXPECT_NEAR(r.largest, 1, 0.02);
}

TEST(TimeLeft, StepsThatGrowOverDecades) {
  const Ratio r = judge(2000, 50, [](double t) { return 0.01 + 0.1 * t; });
  EXPECT_GT(r.count, 50);
  EXPECT_GT(r.least, 1 / 1.5);
  EXPECT_LT(r.largest, 1.5);
}

TEST(TimeLeft, StepsThatGrowSlowerOrFasterThanAssumed) {
  for (double power : {0.7, 1.3}) {
    const Ratio r = judge(2000, 50, [power](double t) { return 0.05 * std::pow(0.05 + t, power); });
    EXPECT_GT(r.least, 1.0 / 4) << power;
    EXPECT_LT(r.largest, 1.5) << power;
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
