// Which times of loads steps meet, which are jumps, and how long steps may be in between.
#include "time/load_times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace softwet {
namespace {

struct Given final : Formula {
  std::function<double(double)> value;
  std::vector<double> points;
  double at(const std::array<double, 3>&, double t) const override { return value(t); }
  std::vector<double> kinks() const override { return points; }
};

/// A case with one load that acts from `start` on with a factor; its clock of results is 0 there.
Case loaded(double start, double ramp, std::function<double(double)> factor = {}, std::vector<double> points = {}) {
  Case c;
  c.time.end = 100;
  Load load;
  load.force = {1, 0};
  load.start = start;
  load.ramp = ramp;
  if (factor) {
    auto formula = std::make_shared<Given>();
    formula->value = std::move(factor);
    formula->points = std::move(points);
    load.factor.formula = formula;
  }
  c.loads = {load};
  return c;
}

/// Linear between points.
std::function<double(double)> table(std::vector<double> t, std::vector<double> y) {
  return [t, y](double x) {
    if (x <= t.front()) return y.front();
    for (std::size_t i = 1; i < t.size(); ++i)
      if (x <= t[i]) return y[i - 1] + (y[i] - y[i - 1]) * (x - t[i - 1]) / (t[i] - t[i - 1]);
    return y.back();
  };
}

TEST(LoadTimes, AStartWithoutARampIsAJumpAndARampIsNot) {
  const LoadTimes sudden(loaded(3, 0)), slow(loaded(3, 5));
  ASSERT_EQ(sudden.jumps().size(), 1);
  EXPECT_EQ(sudden.behind(2.9), 2.9);
  EXPECT_GT(sudden.behind(3), 3);
  EXPECT_NEAR(sudden.behind(3), 3, 1e-14);
  EXPECT_EQ(sudden.behind(sudden.behind(3)), sudden.behind(3)) << "time goes on from there";
  EXPECT_TRUE(slow.jumps().empty());
  EXPECT_EQ(slow.kinks(), (std::vector<double>{3, 8}));
}

TEST(LoadTimes, AShortRampIsOneJumpOrEndsWithOne) {
  const LoadTimes no_time(loaded(3, 1e-9));
  ASSERT_EQ(no_time.jumps().size(), 1);
  EXPECT_EQ(no_time.kinks(), std::vector<double>{3}) << "nothing happens in between";
  EXPECT_GT(no_time.behind(3), 3 + 1e-9);
  const LoadTimes brief(loaded(3, 1e-4));
  EXPECT_EQ(brief.kinks(), (std::vector<double>{3, 3 + 1e-4}));
  EXPECT_EQ(brief.behind(3), 3);
  EXPECT_GT(brief.behind(3 + 1e-4), 3 + 1e-4) << "rates of the ramp are none of what follows";
}

TEST(LoadTimes, PointsOfATableThatAreNearAreAJumpWhereTheValueChanges) {
  for (const double gap : {1e-13, 1e-9}) {
    const std::vector<double> t{0, 1, 1 + gap, 2, 2 + gap, 5};
    const LoadTimes times(loaded(0, 1, table(t, {1, 1, 3, 2, 2, 2}), t));
    ASSERT_EQ(times.jumps().size(), 1) << gap;
    EXPECT_EQ(times.jumps()[0].time, 1);
    EXPECT_GT(times.behind(1), 1 + gap);
    EXPECT_EQ(times.behind(2), 2) << "nothing changes there";
  }
}

TEST(LoadTimes, AFineTableHasNoJumps) {
  std::vector<double> t, y;
  for (int i = 0; i <= 1000; ++i) {
    t.push_back(0.001 * i);
    y.push_back(std::sin(t.back()));
  }
  const LoadTimes times(loaded(0, 1, table(t, y), t));
  EXPECT_TRUE(times.jumps().empty() || times.jumps().back().time > 0.999) << "but for its end";
  EXPECT_EQ(times.longest(0.5, 10), 10) << "points of tables are events";
}

TEST(LoadTimes, StepsResolveAPeriodHoweverLongTheyWouldBe) {
  const double period = 0.5;
  const LoadTimes times(loaded(0, 1, [=](double t) { return 1e-3 * std::sin(2 * M_PI * t / period); }));
  for (const double wish : {50.0, 1.0, 0.5, 0.25})
    for (double t = 1; t < 2; t += 0.0371) {
      const double dt = times.longest(t, wish);
      EXPECT_LT(dt, 0.06 * period) << t;
      EXPECT_GT(dt, 0.025 * period) << t;
    }
  EXPECT_EQ(times.longest(1, 0.01), 0.01);
  const LoadTimes slow(loaded(0, 1, [=](double t) { return std::sin(2 * M_PI * t / 1000); }));
  EXPECT_EQ(slow.longest(1, 10), 10);
}

TEST(LoadTimes, AShortPulseIsNotSteppedOver) {
  const LoadTimes times(loaded(0, 1, [](double t) { return std::exp(-std::pow((t - 40) / 0.05, 2)); }));
  double t = 0, most = 0;
  for (int n = 0; n < 2000 && t < 80; ++n) {
    t += times.longest(t, 50);
    most = std::max(most, std::exp(-std::pow((t - 40) / 0.05, 2)));
  }
  EXPECT_GT(t, 80);
  EXPECT_GT(most, 0.9) << "a step ends in the pulse";
}

TEST(LoadTimes, AJumpOfAnExpressionIsFound) {
  const double at = 7.123456789;
  const LoadTimes times(loaded(0, 1, [=](double t) { return t < at ? 0.0 : 1.0; }));
  double t = 0;
  int steps = 0;
  while (t < at - 1e-7 && ++steps < 50) t += times.longest(t, 5);
  EXPECT_LT(steps, 5);
  EXPECT_LT(t, at) << "a step ends before the jump";
  EXPECT_NEAR(t, at, 1e-7);
  EXPECT_GT(times.behind(t), at) << "and the next one begins behind it";
  EXPECT_EQ(times.longest(times.behind(t), 5), 5);
}

TEST(LoadTimes, AJumpEndsAStepAtTheLastNumberBeforeIt) {
  for (const double at : {0.3, 5.0, 731.3}) {
    const LoadTimes times(loaded(0, 1, [=](double t) { return t < at ? 0.0 : 1.0; }));
    const double t = at - 0.2, before = t + times.longest(t, 0.5);
    EXPECT_LT(before, at);
    EXPECT_NEAR(before, at, 4e-16 * at);
    EXPECT_EQ(times.jump_at(before), before);
    EXPECT_GT(times.behind(before), at);
    EXPECT_NEAR(times.behind(before), at, 1e-15 * at);
    EXPECT_TRUE(std::isinf(times.jump_at(t)));
    EXPECT_TRUE(std::isinf(times.jump_at(times.behind(before))));
  }
}

TEST(LoadTimes, AJumpThatIsAllButThereBoundsNoStepBeforeIt) {
  for (const double near : {0.0, 1e-12, 0.6e-8, 1.7e-8}) {
    Case c = loaded(0, 1, [](double t) { return t < 7 ? 0.0 : 1.0; });
    c.loads.push_back(loaded(0, 1, [=](double t) { return t < 7 + near ? 0.0 : 1.0; }).loads[0]);
    const LoadTimes times(c);
    const double before = 4 + times.longest(4, 5);
    EXPECT_NEAR(before, 7, 4e-15) << near;
    EXPECT_GT(times.behind(before), 7 + near) << "of both";
  }
}

/// A needle combined with a load that begins at run time 3, where t is 0.
Case with_needle(std::function<double(double)> path, std::vector<double> points = {}) {
  Case c = loaded(3, 5);
  auto formula = std::make_shared<Given>();
  formula->value = std::move(path);
  formula->points = std::move(points);
  Needle needle{{0, 0}, {1, 1}, 1, {0, 0}};
  needle.path[0].formula = formula;
  c.needles = {needle};
  return c;
}

TEST(LoadTimes, PathsOfNeedlesCountFromTheClockOfResultsOn) {
  const LoadTimes points(with_needle(table({-1, 2, 4, 4 + 1e-12, 6}, {0, 0, 1, 3, 3}), {-1, 2, 4, 4 + 1e-12, 6}));
  EXPECT_EQ(points.kinks(), (std::vector<double>{3, 8, 5, 7, 9}));
  ASSERT_EQ(points.jumps().size(), 1);
  EXPECT_EQ(points.jumps()[0].time, 7);
  EXPECT_GT(points.behind(7), 7);
  const LoadTimes swing(with_needle([](double t) { return std::sin(t); }));
  EXPECT_EQ(swing.longest(0, 2), 2) << "it stands still before";
  EXPECT_LT(swing.longest(3, 50), 1);
}

TEST(LoadTimes, ALoadThatBeginsLaterBoundsNoStepBefore) {
  const LoadTimes times(loaded(10, 1, [](double t) { return std::sin(20 * t); }));
  EXPECT_EQ(times.longest(0, 10), 10);
  EXPECT_LT(times.longest(0, 50), 11);
}

}  // namespace
}  // namespace softwet
