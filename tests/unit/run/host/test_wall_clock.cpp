// A run with a limit on the clock on the wall leaves room for another step and its last checkpoint.
#include "run/host/wall_clock.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

constexpr double hour = 3600;

TEST(WallClock, NoLimitIsNeverOver) { EXPECT_FALSE(WallClock(0).over(1e12)); }

TEST(WallClock, IsOverBeforeTheLimit) {
  const WallClock clock(1);
  EXPECT_FALSE(clock.over(0.98 * hour));
  EXPECT_TRUE(clock.over(0.991 * hour));
}

TEST(WallClock, LeavesRoomForTheLongestStepAndTheLongestCheckpoint) {
  WallClock clock(1);
  for (double seconds : {10.0, 60.0, 20.0}) clock.step(seconds);
  for (double seconds : {30.0, 5.0}) clock.save(seconds);
  EXPECT_FALSE(clock.over(0.99 * hour - 2 * (60 + 30) - 1));
  EXPECT_TRUE(clock.over(0.99 * hour - 2 * (60 + 30) + 1));
}

// It is perhaps being written when the run has to stop.
TEST(WallClock, LeavesRoomForAFile) {
  WallClock clock(1);
  clock.step(60);
  clock.save(30);
  for (double seconds : {0.0, 40.0, 10.0}) clock.file(seconds);
  EXPECT_FALSE(clock.over(0.99 * hour - 2 * (60 + 40 + 30) - 1));
  EXPECT_TRUE(clock.over(0.99 * hour - 2 * (60 + 40 + 30) + 1));
}

}  // namespace
}  // namespace softwet
