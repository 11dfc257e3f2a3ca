// The largest eigenvalue of small matrices whose eigenvalues are known.
#include "time/power_iteration.hpp"

#include <gtest/gtest.h>

#include <array>

namespace softwet {
namespace {

/// z -> A z for a matrix of 3 x 3.
struct Matrix3 {
  std::array<double, 9> a;
  bool operator()(const Array& z, const Array& out) const {
    const std::vector<double> x = to_host(z);
    std::vector<double> y(3, 0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) y[i] += a[3 * i + j] * x[j];
    Kokkos::deep_copy(out, to_device<Array>(y));
    return true;
  }
};

TEST(PowerIteration, ARealNegativeEigenvalue) {
  PowerIteration power(alone, 3);
  power.measure(Matrix3{{-5, 1, 0, 0, -2, 0, 0, 0, -1}});
  EXPECT_NEAR(power.radius(), 5, 0.05);
  EXPECT_FALSE(power.imaginary());
}

// u' = v, v' = -w^2 u with w = 100: the parts of the vector differ in size by w, and the eigenvalues are +- i w.
TEST(PowerIteration, AnOscillationInVariablesOfDifferentSize) {
  for (const double w : {1.5, 100.0}) {
    PowerIteration power(alone, 3);
    power.measure(Matrix3{{0, 1, 0, -w * w, 0, 0, 0, 0, -0.1 * w}});
    EXPECT_NEAR(power.radius(), w, 0.02 * w);
    EXPECT_TRUE(power.imaginary()) << w;
  }
}

TEST(PowerIteration, NoProductLeavesNoRadius) {
  PowerIteration power(alone, 3);
  power.measure([](const Array&, const Array&) { return false; });
  EXPECT_EQ(power.radius(), 0);
}

}  // namespace
}  // namespace softwet
