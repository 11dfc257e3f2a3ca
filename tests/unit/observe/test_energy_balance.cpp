// When the energy of a run counts as having risen though nothing fed it.
#include "observe/host/energy_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

EnergyState state(double time, double energy, double kinetic = 0, double fed = 0, double lost = 0) {
  return {time, energy, std::abs(energy), kinetic, fed, lost};
}

TEST(EnergyBalance, WhatIsFedIsNoRise) {
  EnergyBalance balance;
  for (int k = 0; k <= 10; ++k) EXPECT_EQ(balance.follow(state(k, 2.0 * k, 0, 2), {0.01}), 0) << k;
  EXPECT_NEAR(balance.rise, 0, 1e-14);
  EXPECT_NEAR(balance.fed, 20, 1e-13);
  // A quarter of the energy fed in may be missing, because powers are known at the states alone.
  EXPECT_EQ(balance.follow(state(11, 20 + 2 + 5.4, 0, 2), {0.01}), 0);
  EXPECT_GT(balance.follow(state(12, 20 + 4 + 6.1, 0, 2), {0.0}), 0);
}

TEST(EnergyBalance, TheShareIsOneOfWhatMovesAndWasLost) {
  for (const double share : {0.005, 0.5}) {
    EnergyBalance balance;
    balance.follow(state(0, 10, 0, 0, 1), {share});
    balance.follow(state(1, 9, 0, 0, 1), {share});  // 1 was lost, and 3 move in the next state
    EnergyBalance other = balance;
    EXPECT_EQ(balance.follow(state(1, 9 + 0.99 * 4 * share, 3), {share}), 0);
    EXPECT_NEAR(other.follow(state(1, 9 + 1.01 * 4 * share, 3), {share}), 1.01 * 4 * share, 1e-12);
  }
}

// Many steps that each rise by too little, and one that rises from below the lowest value.
TEST(EnergyBalance, RisesAddUpFromTheLowestValue) {
  EnergyBalance balance;
  balance.follow(state(0, 10, 1), {0.1});
  for (int k = 1; k <= 3; ++k) EXPECT_EQ(balance.follow(state(k, 10 + 0.03 * k, 1), {0.1}), 0);
  EXPECT_NEAR(balance.follow(state(4, 10.12, 1), {0.1}), 0.12, 1e-12);
  balance = {};
  balance.follow(state(0, 10, 1), {0.1});
  EXPECT_EQ(balance.follow(state(1, 9.5, 1), {0.1}), 0);
  EXPECT_NEAR(balance.follow(state(2, 9.7, 1), {0.1}), 0.2, 1e-12) << "still below the first value";
}

// Where a wave turns nothing moves for a moment; what moved before is the measure still.
TEST(EnergyBalance, AWaveThatTurnsIsMeasuredByWhatMoved) {
  EnergyBalance balance;
  balance.follow(state(0, 10, 1), {0.01});
  EXPECT_EQ(balance.follow(state(1, 10.009, 0), {0.01}), 0);
  EXPECT_GT(balance.follow(state(2, 10.011, 0), {0.01}), 0);
}

TEST(EnergyBalance, AnEpisodeIsReportedOnce) {
  EnergyBalance balance;
  const auto told = [&](double time, double energy) { return balance.follow(state(time, energy, 1), {0.1}) > 0; };
  told(0, 10);
  EXPECT_TRUE(told(1, 10.2));
  EXPECT_FALSE(told(2, 10.6)) << "it goes on";
  EXPECT_FALSE(told(3, 10.5)) << "it ends";
  EXPECT_FALSE(told(4, 10.55));
  EXPECT_TRUE(told(5, 10.7)) << "another one";
}

// An energy that swings below the kept energy, and then stands above its first value.
TEST(EnergyBalance, OneThatSwingsIsHeldAgainstItsFirstValue) {
  constexpr EnergyRule rule{0.25, EnergyFloor::first};
  EnergyBalance balance;
  for (int k = 0; k < 20; ++k) EXPECT_EQ(balance.follow(state(k, 10 - 6 * (k % 2), 2), rule), 0) << k;
  EXPECT_EQ(balance.follow(state(20, 10.49, 2), rule), 0);
  EXPECT_NEAR(balance.follow(state(21, 10.6, 2), rule), 0.6, 1e-12);
  EXPECT_EQ(balance.follow(state(22, 14, 2), rule), 0) << "it goes on";
  EXPECT_EQ(balance.follow(state(23, 9, 2), rule), 0) << "it ends";
  EXPECT_GT(balance.follow(state(24, 11, 2), rule), 0) << "another one";
}
TEST(EnergyBalance, WhatIsLostCannotBeGainedBack) {
  constexpr EnergyRule rule{0.25, EnergyFloor::first};
  EnergyBalance balance;
  balance.follow(state(0, 10, 1, 0, 2), rule);
  EXPECT_EQ(balance.follow(state(1, 8, 1, 0, 2), rule), 0);
  EXPECT_NEAR(balance.follow(state(2, 9, 1, 0, 2), rule), 3, 1e-12) << "10 - 4 would be right";
}

// At rest nothing moves and nothing was lost: only round-off is left.
TEST(EnergyBalance, RoundOffIsNoRise) {
  EnergyBalance balance;
  for (int k = 0; k < 1000; ++k)
    EXPECT_EQ(balance.follow(state(k, 1 + 4e-16 * (k % 2 == 0 ? 1 : -1)), {0.005}), 0) << k;
}

}  // namespace
}  // namespace softwet
