// Steps that follow a bound without its swings.
#include "time/explicit/held_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

TEST(HeldRate, IsThatOfABoundThatIsConstantOrFalls) {
  HeldRate held;
  for (const double rate : {1.0, 1.0, 1.5, 1.5, 7.0}) {
    held.follow(rate);
    EXPECT_EQ(held.value(), rate);
  }
}

TEST(HeldRate, DoesNotFollowSwings) {
  HeldRate held;
  for (int n = 0; n < 2000; ++n) {
    const double rate = 10 + std::cos(0.09 * n);
    held.follow(rate);
    EXPECT_GE(held.value(), rate);
    if (n > 200) {
      EXPECT_NEAR(held.value(), 11, 0.01) << n;
    }
  }
}

TEST(HeldRate, FallsLateAndSlowly) {
  HeldRate held;
  held.follow(10);
  double before = held.value();
  int steps = 0;
  for (; held.value() > 2 && steps < 1000; ++steps) {
    held.follow(2);
    EXPECT_GE(held.value(), (1 - HeldRate::fall) * before - 1e-12);
    if (steps < HeldRate::window - 1) {
      EXPECT_EQ(held.value(), 10) << steps;
    }
    before = held.value();
  }
  EXPECT_EQ(steps, HeldRate::window + static_cast<int>(std::ceil(std::log(0.2) / std::log(1 - HeldRate::fall))) - 1);
  for (int n = 0; n < 1000; ++n) held.follow(1.7);
  EXPECT_EQ(held.value(), 2) << "not for less than a fifth";
}

}  // namespace
}  // namespace softwet
