// Van der Waals fluid: values, thermodynamic identities, and the continuation to small densities.
#include "kernels/fluid/van_der_waals.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

template <class F>
double difference(const F& f, double x, double e) {
  return (8 * (f(x + e) - f(x - e)) - f(x + 2 * e) + f(x - 2 * e)) / (12 * e);
}

// rho = 1/2: the logarithm vanishes, so W = -1/4, W' = (16/27) theta - 1, p = (8/27) theta - 1/4.
TEST(VanDerWaals, ClosedValuesAtHalf) {
  const VanDerWaals gas{0.81, 0};
  EXPECT_NEAR(gas.energy(0.5), -0.25, 1e-16);
  EXPECT_NEAR(gas.derivative(0.5), 0.48 - 1, 1e-15);
  EXPECT_NEAR(gas.pressure(0.5), 0.24 - 0.25, 1e-15);
  EXPECT_NEAR(gas.curvature(0.5), 0.24 / 0.125 - 2, 1e-15);
}

// Critical point: theta = 1, rho = 1/3, p = 1/27, p' = p'' = 0.
TEST(VanDerWaals, CriticalPoint) {
  const VanDerWaals gas{1.0, 0};
  EXPECT_NEAR(gas.pressure(1.0 / 3), 1.0 / 27, 1e-16);
  const auto p = [&](double r) { return gas.pressure(r); };
  EXPECT_NEAR(difference(p, 1.0 / 3, 1e-3), 0, 1e-10);
  EXPECT_NEAR((p(1.0 / 3 + 1e-3) - 2 * p(1.0 / 3) + p(1.0 / 3 - 1e-3)) / 1e-6, 0, 1e-5);
}

TEST(VanDerWaals, DerivativeAndCurvatureAgainstDifferences) {
  for (const double r0 : {0.0, 0.05}) {
    const VanDerWaals gas{0.39, r0};
    for (double r = 0.01; r < 0.95; r += 0.0173) {
      const double e = std::min(2e-4, 0.02 * r);
      EXPECT_NEAR(difference([&](double x) { return gas.energy(x); }, r, e), gas.derivative(r), 1e-7) << r;
      if (r > r0 + 2 * e) {
        EXPECT_NEAR(difference([&](double x) { return gas.derivative(x); }, r, e), gas.curvature(r),
                    1e-5 * std::abs(gas.curvature(r)) + 1e-8);
      }
      EXPECT_NEAR(gas.pressure(r), r * gas.derivative(r) - gas.energy(r), 1e-15);
    }
  }
}

TEST(VanDerWaals, PressureIsTheEquationOfState) {
  const VanDerWaals gas{0.39, 0};
  for (double r = 0.001; r < 0.99; r += 0.0371)
    EXPECT_NEAR(gas.pressure(r), 8.0 / 27 * 0.39 * r / (1 - r) - r * r, 1e-13);
}

// Below the continuation W is the parabola through (W, W', W'') there: C2, finite and convex for any density.
TEST(VanDerWaals, ContinuationIsC2AndQuadratic) {
  const double r0 = 0.2 * 0.001352289801;
  const VanDerWaals gas{0.39, r0}, bare{0.39, 0};
  EXPECT_NEAR(gas.energy(r0 * (1 - 1e-9)), bare.energy(r0), 1e-11);
  EXPECT_NEAR(gas.derivative(r0 * (1 - 1e-9)), bare.derivative(r0), 1e-8);
  const double h = 0.1 * r0;
  for (const double r : {0.9 * r0, 0.0, -5 * r0}) {
    const double second = (gas.derivative(r) - gas.derivative(r - h)) / h;
    EXPECT_NEAR(second, bare.curvature(r0), 1e-9 * bare.curvature(r0));
    EXPECT_NEAR(gas.energy(r) - gas.energy(r - h), 0.5 * h * (gas.derivative(r) + gas.derivative(r - h)), 1e-15);
  }
  EXPECT_GT(bare.curvature(r0), 0);
  for (const double r : {1.001 * r0, 0.3}) EXPECT_NEAR(gas.energy(r), bare.energy(r), 1e-15);
}

TEST(VanDerWaals, DualIsTheDerivative) {
  const VanDerWaals gas{0.85, 0.03};
  for (const double r : {-0.02, 0.01, 0.0299, 0.0301, 0.4, 0.9}) {
    const Dual<double> x(r, 2.0);
    EXPECT_NEAR(gas.energy(x).tangent, 2 * gas.derivative(r), 1e-14);
    EXPECT_NEAR(gas.derivative(x).tangent, 2 * gas.curvature(std::max(r, 0.03)), 1e-12);
    EXPECT_NEAR(gas.energy(x).value, gas.energy(r), 1e-15);
  }
}

}  // namespace
}  // namespace softwet
