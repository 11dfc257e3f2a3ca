// Step control: events are met exactly, steps grow and shrink within bounds, rejection halves.
#include "time/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

const StepLimits limits{0.1, 1e-3, 2.0, 1e-3};

TEST(StepControl, EventsAreMetExactly) {
  StepControl control(limits, {7.3, 1.0, 1.05, 2.5});
  double t = 0;
  std::vector<double> met;
  for (int n = 0; n < 400 && t < 7.3; ++n) {
    const double dt = control.next(t), before = t;
    ASSERT_GT(dt, 1e-9);
    t += dt;
    for (const double event : {1.0, 1.05, 2.5, 7.3}) {
      EXPECT_FALSE(before < event - 1e-9 && t > event + 1e-9) << "stepped over " << event;
      if (std::abs(t - event) < 1e-9) {
        EXPECT_NEAR(t, event, 4e-16 * event);
        met.push_back(event);
      }
    }
    control.accept(dt, 1e-6);
  }
  EXPECT_EQ(met, (std::vector<double>{1.0, 1.05, 2.5, 7.3}));
}

TEST(StepControl, NoSliverBeforeAnEvent) {
  StepControl control(limits, {1.0});
  EXPECT_DOUBLE_EQ(control.next(0.0), 0.1);
  EXPECT_DOUBLE_EQ(control.next(0.895), 0.105) << "stretched by a tenth";
  EXPECT_DOUBLE_EQ(control.next(0.85), 0.075) << "two equal steps rather than a long and a short one";
  EXPECT_DOUBLE_EQ(control.next(1.0), 0.1) << "an event that has been met is past";
}

// A step may stretch to an event, but not beyond the largest one; it is halved then.
TEST(StepControl, TheLargestStepIsNotExceededBeforeAnEvent) {
  StepControl control(limits, {10.0});
  control.set_proposed(limits.largest);
  EXPECT_DOUBLE_EQ(control.next(0.0), 2.0);
  EXPECT_DOUBLE_EQ(control.next(8.0), 2.0) << "just as far away";
  EXPECT_NEAR(control.next(8.0 - 1e-13), 2.0, 1e-12) << "just as far away but for the rounding of a sum of steps";
  EXPECT_DOUBLE_EQ(control.next(7.9), 1.05) << "two equal steps";
  for (double t = 0; t < 10;) {
    const double dt = control.next(t);
    ASSERT_LE(dt, limits.largest);
    t += dt;
    if (std::abs(t - 10) < 1e-9) break;
  }
}

TEST(StepControl, AnEventIsMetByAStepBelowTheSmallest) {
  StepControl control(limits, {1.0, 1.0 + 0.1 * limits.smallest});
  EXPECT_NEAR(control.next(1.0), 0.1 * limits.smallest, 1e-15);
}

TEST(StepControl, EventsThatDifferByARoundingAreOne) {
  StepControl control(limits, {1.0 + 3e-10, 1.0, 1.5});
  EXPECT_DOUBLE_EQ(control.next(0.95), 1.0 - 0.95);
  EXPECT_DOUBLE_EQ(control.next(1.0), 0.1);
}

TEST(StepControl, NoStepEndsBehindAJump) {
  StepControl control(limits, {1.0});
  const double jump = std::nextafter(1.0, 0.0), unbounded = std::numeric_limits<double>::infinity();
  EXPECT_EQ(0.93 + control.next(0.93, jump - 0.93, jump), jump) << "not at an event just behind";
  EXPECT_EQ(0.93 + control.next(0.93, unbounded, 1.05), 1.0) << "at an event before";
  EXPECT_DOUBLE_EQ(control.next(1.0, unbounded, 1.05), 1.05 - 1.0);
}

TEST(StepControl, GrowthFollowsTheIndicator) {
  StepControl control(limits, {});
  control.accept(0.1, 1e-3);  // as large as wanted: factor 0.9
  EXPECT_DOUBLE_EQ(control.proposed(), 0.09);
  control.set_proposed(0.1);
  control.accept(0.1, 0.81e-3);  // 0.9 sqrt(1 / 0.81) = 1
  EXPECT_NEAR(control.proposed(), 0.1, 1e-15);
  control.set_proposed(0.1);
  control.accept(0.1, 1e-12);
  EXPECT_DOUBLE_EQ(control.proposed(), 0.15) << "at most half as much again";
  control.set_proposed(0.1);
  control.accept(0.1, 1e3);
  EXPECT_DOUBLE_EQ(control.proposed(), 0.05) << "at least half";
  control.set_proposed(0.1);
  control.accept(0.1, 0.0);
  EXPECT_DOUBLE_EQ(control.proposed(), 0.15) << "nothing moves";
}

// Creeping adds up what swinging forgets.
TEST(StepControl, LongStepsMayHaveASmallerError) {
  StepLimits slow = limits;
  slow.slow = 0.1;
  StepControl control(slow, {});
  EXPECT_DOUBLE_EQ(control.allowed(0.05), 1e-3);
  EXPECT_DOUBLE_EQ(control.allowed(0.1), 1e-3);
  EXPECT_DOUBLE_EQ(control.allowed(0.2), 0.5e-3);
  EXPECT_DOUBLE_EQ(control.allowed(1.9), 0.25e-3);
  EXPECT_DOUBLE_EQ(control.rejection_level(1.9), 1e-3);
  const auto settled = [](StepControl& steps, double curvature) {
    for (int n = 0; n < 40; ++n) steps.accept(steps.proposed(), curvature * steps.proposed() * steps.proposed());
    return steps.proposed();
  };
  StepControl usual(limits, {});
  EXPECT_NEAR(settled(usual, 1e-3), 0.9, 1e-9);
  EXPECT_NEAR(settled(control, 1e-3), 0.45, 1e-9) << "half as long where a step is more than four times slow";
  EXPECT_DOUBLE_EQ(settled(control, 0.1), settled(usual, 0.1)) << "as long where it is not slow";
}

TEST(StepControl, LaboriousNewtonShrinksTheStep) {
  StepControl control(limits, {});
  control.accept(0.1, 1e-12, Effort::laborious);
  EXPECT_DOUBLE_EQ(control.proposed(), 0.09);
}

TEST(StepControl, CutStepDoesNotForgetTheProposal) {
  StepControl control(limits, {});
  control.accept(0.01, 1e-12);
  EXPECT_DOUBLE_EQ(control.proposed(), 0.1);
}

TEST(StepControl, TheLargestStepOfASchemeIsNotExceeded) {
  StepControl control(limits, {1.0});
  EXPECT_DOUBLE_EQ(control.next(0.0, 0.011), 0.011);
  EXPECT_DOUBLE_EQ(control.next(0.9895, 0.011), 1.0 - 0.9895) << "to an event";
  EXPECT_NEAR(control.next(0.9885, 0.011), 0.5 * (1.0 - 0.9885), 1e-15) << "not stretched to an event";
  EXPECT_DOUBLE_EQ(control.next(0.989, 0.011 - 1e-13), 1.0 - 0.989) << "but by a rounding";
  EXPECT_DOUBLE_EQ(control.next(0.0), 0.1) << "the proposal stays";
}

TEST(StepControl, Clamps) {
  StepControl control(limits, {});
  for (int n = 0; n < 50; ++n) control.accept(control.next(0), 1e-12);
  EXPECT_DOUBLE_EQ(control.proposed(), 2.0);
  for (int n = 0; n < 50; ++n) control.accept(control.next(0), 1e3);
  EXPECT_DOUBLE_EQ(control.proposed(), 1e-3);
  control.set_proposed(50);  // of a run with other limits
  EXPECT_DOUBLE_EQ(control.proposed(), 2.0);
  control.set_proposed(1e-9);
  EXPECT_DOUBLE_EQ(control.proposed(), 1e-3);
}

TEST(StepControl, RejectionHalvesUntilTheSmallestStep) {
  StepControl control(limits, {});
  EXPECT_TRUE(control.reject(0.1));
  EXPECT_DOUBLE_EQ(control.next(0), 0.05);
  double dt = 0.05;
  int halvings = 0;
  while (control.reject(dt)) {
    dt = control.next(0);
    ASSERT_LT(++halvings, 20);
  }
  EXPECT_EQ(halvings, 5);  // 0.05 / 2^5 = 1.5625e-3; the next would be below 1e-3
  EXPECT_DOUBLE_EQ(control.rejection_level(dt), 4e-3);
}

}  // namespace
}  // namespace softwet
