// Newtonian stress by hand, and what the Stokes hypothesis says of its trace.
#include "kernels/fluid/newtonian.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

TEST(Newtonian, ByHandIn2D) {
  const Matrix<double, 2> g{{{1, 2}, {5, 7}}};
  const auto tau = newtonian_stress(3.0, g);
  EXPECT_DOUBLE_EQ(tau(0, 0), 6 - 16);
  EXPECT_DOUBLE_EQ(tau(0, 1), 21);
  EXPECT_DOUBLE_EQ(tau(1, 0), 21);
  EXPECT_DOUBLE_EQ(tau(1, 1), 42 - 16);
}

TEST(Newtonian, TraceVanishesIn3D) {
  const Matrix<double, 3> g{{{0.3, -0.2, 0.7}, {0.1, 0.9, -1.1}, {0.4, 0.6, -0.5}}};
  EXPECT_NEAR(trace(newtonian_stress(0.7, g)), 0, 1e-15);
}

// Plane motion: the third normal stress is -(2/3) m div v, so the 2D trace is its opposite.
TEST(Newtonian, TraceOfPlaneMotion) {
  const Matrix<double, 2> g{{{0.3, -0.2}, {0.1, 0.9}}};
  EXPECT_NEAR(trace(newtonian_stress(0.7, g)), 2.0 / 3 * 0.7 * 1.2, 1e-15);
}

TEST(Newtonian, RotationIsFree) {
  const Matrix<double, 2> g{{{0, -2}, {2, 0}}};
  const auto tau = newtonian_stress(0.7, g);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_EQ(tau(i, j), 0);
}

TEST(Newtonian, NeverGainsEnergy) {
  for (int n = 0; n < 40; ++n) {
    Matrix<double, 3> g;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) g(i, j) = std::sin(1 + 9.1 * n + 3.7 * i + 1.3 * j);
    EXPECT_GE(contract(newtonian_stress(0.7, g), g), 0);
  }
}

}  // namespace
}  // namespace softwet
