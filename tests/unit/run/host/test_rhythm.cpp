// Checkpoints and records come soon after the start, and then at their pauses, however long a step takes.
#include "run/host/rhythm.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

TEST(Rhythm, TheFirstTimeIsSoonerThanTheOthers) {
  Rhythm saves(60, 600);
  EXPECT_FALSE(saves.due(59));
  EXPECT_TRUE(saves.due(61));
  EXPECT_FALSE(saves.due(62));
  EXPECT_FALSE(saves.due(660));
  EXPECT_TRUE(saves.due(661));
}

TEST(Rhythm, ALongStepIsFollowedByAWholePause) {
  Rhythm records(15, 15);
  EXPECT_TRUE(records.due(100));
  EXPECT_FALSE(records.due(114));
  EXPECT_TRUE(records.due(115));
}

TEST(Rhythm, APauseOfNothingIsAlwaysDue) {
  Rhythm saves(0, 0);
  for (double now : {0.0, 0.0, 1e-3}) EXPECT_TRUE(saves.due(now));
}

}  // namespace
}  // namespace softwet
