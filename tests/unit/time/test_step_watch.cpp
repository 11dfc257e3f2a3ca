// Which steps look as if they were beyond the limit of stability, and where liquid at a side asks for a new limit.
#include "time/step_watch.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

constexpr double wet = 0.2;

StepSigns signs(double time, double energy, double lost, double fed = 0) {
  StepSigns s;
  s.energy = {time, energy, 1, 0.1, fed, lost};
  return s;
}

StepWatch begun(bool energy_law, double lost = 1e-3) {
  StepWatch watch(wet, energy_law);
  watch.begin(signs(0, -1, lost));
  return watch;
}

TEST(StepWatch, AStepWhoseEnergyRisesGrowsWhereThereIsALawForIt) {
  for (const bool law : {true, false}) {
    const StepWatch watch = begun(law);
    EXPECT_FALSE(watch.grows(signs(0.1, -1 - 1e-4, 1e-3)));
    EXPECT_FALSE(watch.grows(signs(0.1, -1 + 1.9e-5, 1e-3))) << "a tenth of what was lost, and 1e-4 of what moves";
    EXPECT_EQ(watch.grows(signs(0.1, -1 + 2.1e-5, 1e-3)), law);
    EXPECT_FALSE(watch.grows(signs(0.1, -1 + 1e-2, 1e-3, 0.2))) << "it was fed";
  }
}

TEST(StepWatch, AStepWhoseDissipationJumpsGrows) {
  StepWatch watch = begun(false);
  EXPECT_FALSE(watch.grows(signs(0.1, -1, 1))) << "of the first step nothing is known";
  watch.accept(signs(0.1, -1, 1.1e-3));
  EXPECT_FALSE(watch.grows(signs(0.2, -1, 1.1 * 1.9e-3)));
  EXPECT_TRUE(watch.grows(signs(0.2, -1, 1.1 * 2.1e-3)));
  watch.accept(signs(0.1, -1, 1e-20));
  EXPECT_FALSE(watch.grows(signs(0.2, -1, 1e-15))) << "round-off of a scene at rest";
}

// From rest the dissipation grows like t^2: by 4, 2.25, 1.78 times, ever more slowly.
TEST(StepWatch, MotionThatBeginsIsNoGrowth) {
  StepWatch watch = begun(false, 0);
  for (int k = 1; k < 20; ++k) {
    EXPECT_FALSE(watch.grows(signs(k, -1, 1e-3 * k * k))) << k;
    watch.accept(signs(k, -1, 1e-3 * k * k));
  }
  EXPECT_TRUE(watch.grows(signs(20, -1, 1)));
}

TEST(StepWatch, LiquidThatMeetsASideAsksForANewLimit) {
  StepWatch watch = begun(true);
  watch.searched();
  const auto met = [&](std::size_t place, double density) {
    StepSigns s = signs(0.1, -1, 1e-3);
    s.density[place] = density;
    return watch.accept(s);
  };
  EXPECT_FALSE(met(0, 0.7)) << "inside";
  for (const std::size_t place : {1, 2, 3}) {
    EXPECT_FALSE(met(place, 1.6 * wet)) << "vapour";
    EXPECT_TRUE(met(place, 1.8 * wet));
    EXPECT_TRUE(met(place, 1.8 * wet)) << "until the limit was searched for";
    watch.searched();
    EXPECT_FALSE(met(place, 3 * wet));
    EXPECT_FALSE(met(place, 1.8 * wet)) << "back";
    EXPECT_TRUE(met(place, 3.1 * wet));
    watch.begin(signs(0, -1, 1e-3));
    watch.searched();
  }
}

}  // namespace
}  // namespace softwet
