// The ramp of a load.
#include "kernels/solid/body_force.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

TEST(BodyForce, LinearRamp) {
  EXPECT_EQ(load_fraction(9.9, 10, 4), 0);
  EXPECT_EQ(load_fraction(10, 10, 4), 0);
  EXPECT_DOUBLE_EQ(load_fraction(11, 10, 4), 0.25);
  EXPECT_DOUBLE_EQ(load_fraction(13, 10, 4), 0.75);
  EXPECT_EQ(load_fraction(14, 10, 4), 1);
  EXPECT_EQ(load_fraction(1e9, 10, 4), 1);
}

TEST(BodyForce, NoRampIsAStep) {
  EXPECT_EQ(load_fraction(10, 10, 0), 0);
  EXPECT_EQ(load_fraction(10.0001, 10, 0), 1);
}

}  // namespace
}  // namespace softwet
