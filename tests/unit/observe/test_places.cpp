// Places and samples that differ by rounding alone are read alike.
#include "observe/host/places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

TEST(Places, EndOfAnAxis) {
  for (const double off : {0.0, 1e-20, -1e-20, 3e-17}) EXPECT_TRUE(at_end(off, 0, 0.03)) << off;
  EXPECT_TRUE(at_end(std::nextafter(0.7, 1), 0.7, 0.03));
  EXPECT_FALSE(at_end(1e-6, 0, 0.03));
}

TEST(Places, TurnsOfAPeriodicAxis) {
  EXPECT_EQ(in_first_turn(-1e-17, 2), 0);
  EXPECT_EQ(in_first_turn(0, 2), 0);
  EXPECT_DOUBLE_EQ(in_first_turn(-0.1, 2), 1.9);
  EXPECT_DOUBLE_EQ(in_first_turn(4.5, 2), 0.5);
  EXPECT_EQ(in_first_turn(std::nextafter(2, 0), 2), 0);
}

// The window of a ridge, 8 g wide, wherever the contact line is.
TEST(Places, PartsOfALengthThatIsAMultiple) {
  const double g = 1.0 / 27;
  for (int i = 0; i < 1000; ++i) {
    const double line = 0.3 + 1e-4 * i;
    EXPECT_EQ(parts_no_longer((line + 4 * g) - (line - 4 * g), 0.5 * g / 8), 128) << line;
  }
  EXPECT_EQ(parts_no_longer(1.01, 0.1), 11);
}

/// Samples of a peak at 10 + shift that is steeper on its left.
std::vector<double> skewed(double shift) {
  std::vector<double> value;
  for (int i = 0; i <= 20; ++i) {
    const double x = i - 10 - shift;
    value.push_back(1 - x * x / (x < 0 ? 50 : 100));
  }
  return value;
}

TEST(Places, TopOfEqualSamples) {
  // Two equal samples, of which the last digit prefers one or the other.
  std::vector<double> value = skewed(0.4);
  value[11] = value[10];
  const double top = top_of(value);
  EXPECT_GT(top, value[10]);
  for (const int i : {10, 11}) {
    std::vector<double> nudged = value;
    nudged[i] = std::nextafter(value[i], 2);
    EXPECT_NEAR(top_of(nudged), top, 1e-14);
  }
  std::reverse(value.begin(), value.end());
  EXPECT_NEAR(top_of(value), top, 1e-15);
}

TEST(Places, TopOfAParabolaAndOfARamp) {
  for (const double place : {2.0, 2.3, 2.5, 2.9}) {
    std::vector<double> value;
    for (int i = 0; i <= 6; ++i) value.push_back(3 - (i - place) * (i - place));
    EXPECT_NEAR(top_of(value), 3, 1e-14) << place;
  }
  EXPECT_EQ(top_of({0, 1, 2, 3}), 3);
  EXPECT_EQ(top_of({3, 1, 0, -2}), 3);
}

}  // namespace
}  // namespace softwet
