// Dual numbers against closed derivatives and differences; packs against scalars, lane by lane.
#include "kernels/algebra/dual.hpp"

#include <gtest/gtest.h>

#include <random>

namespace softwet {
namespace {

using Number = Dual<double>;

void expect_dual(const Number& x, double value, double tangent) {
  EXPECT_NEAR(x.value, value, 1e-14 * (1 + std::abs(value)));
  EXPECT_NEAR(x.tangent, tangent, 1e-14 * (1 + std::abs(tangent)));
}

TEST(Dual, ClosedDerivatives) {
  const Number x(0.7, 2.0), y(-1.3, 0.5);
  expect_dual(x + y, -0.6, 2.5);
  expect_dual(x - y, 2.0, 1.5);
  expect_dual(-x, -0.7, -2.0);
  expect_dual(x * y, -0.91, 2.0 * -1.3 + 0.7 * 0.5);
  expect_dual(x / y, 0.7 / -1.3, (2.0 * -1.3 - 0.7 * 0.5) / (1.3 * 1.3));
  expect_dual(x + 3.0, 3.7, 2.0);
  expect_dual(3.0 + x, 3.7, 2.0);
  expect_dual(x - 3.0, -2.3, 2.0);
  expect_dual(3.0 - x, 2.3, -2.0);
  expect_dual(3.0 * x, 2.1, 6.0);
  expect_dual(x * 3.0, 2.1, 6.0);
  expect_dual(1.0 / x, 1 / 0.7, -2.0 / 0.49);
  expect_dual(logarithm(x), std::log(0.7), 2.0 / 0.7);
  expect_dual(square_root(x), std::sqrt(0.7), 1.0 / std::sqrt(0.7));
  Number sum = x;
  sum += y;
  expect_dual(sum, -0.6, 2.5);
  expect_dual(Number(4.0), 4.0, 0.0);
}

TEST(Dual, SelectTakesValueAndTangentOfOneBranch) {
  const Number x(0.7, 2.0), y(-1.3, 0.5);
  expect_dual(select(x < 1.0, x, y), 0.7, 2.0);
  expect_dual(select(x < 0.5, x, y), -1.3, 0.5);
}

TEST(Dual, OutcomeIsTheTangent) {
  EXPECT_EQ(outcome(Number(3.0, 5.0)), 5.0);
  EXPECT_EQ(outcome(3.0), 3.0);
}

template <class N>
N formula(const N& x, const N& y) {
  const N s = square_root(x * x + y * y + 0.1);
  return select(x < 0.6, logarithm(s) / (2.0 + y) - x * y, s / x - 3.0 * y + 1.0 / s);
}

TEST(Dual, CompositeAgainstDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.1, 1.1);
  for (int n = 0; n < 50; ++n) {
    const double x = uniform(random), y = uniform(random), dx = uniform(random), dy = -uniform(random), e = 1e-4;
    if (std::abs(x - 0.6) < 3e-4) continue;
    const auto at = [&](double t) { return formula(x + t * dx, y + t * dy); };
    const double expected = (8 * (at(e) - at(-e)) - at(2 * e) + at(-2 * e)) / (12 * e);
    EXPECT_NEAR(formula(Number(x, dx), Number(y, dy)).tangent, expected, 1e-9 * (1 + std::abs(expected)));
  }
}

TEST(Pack, LanesEqualScalars) {
  using P = Pack<double>;
  constexpr int lanes = Lanes<P>::count;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(0.01, 1.2);
  for (int n = 0; n < 50; ++n) {
    double x[lanes], y[lanes], dx[lanes], dy[lanes];
    for (int l = 0; l < lanes; ++l) {
      x[l] = uniform(random);
      y[l] = uniform(random);
      dx[l] = uniform(random);
      dy[l] = uniform(random);
    }
    const P plain = formula(load<P>(x), load<P>(y));
    const Dual<P> dual = formula(Dual<P>(load<P>(x), load<P>(dx)), Dual<P>(load<P>(y), load<P>(dy)));
    for (int l = 0; l < lanes; ++l) {
      const Number expected = formula(Number(x[l], dx[l]), Number(y[l], dy[l]));
      EXPECT_NEAR(plain[l], expected.value, 1e-14 * (1 + std::abs(expected.value)));
      EXPECT_NEAR(dual.value[l], expected.value, 1e-14 * (1 + std::abs(expected.value)));
      EXPECT_NEAR(dual.tangent[l], expected.tangent, 1e-13 * (1 + std::abs(expected.tangent)));
    }
  }
}

// The vector logarithm may differ from the C library by a few units in the last place, and must reach small densities.
TEST(Pack, LogarithmOverManyDecades) {
  using P = Pack<double>;
  constexpr int lanes = Lanes<P>::count;
  for (double start = 1e-300; start < 1e300; start *= 1e7) {
    double x[lanes];
    for (int l = 0; l < lanes; ++l) x[l] = start * (1 + 0.37 * l);
    const P y = logarithm(load<P>(x));
    for (int l = 0; l < lanes; ++l) EXPECT_NEAR(y[l], std::log(x[l]), 1e-15 * std::abs(std::log(x[l])));
  }
}

TEST(Pack, AddToAddsEveryLane) {
  using P = Pack<double>;
  constexpr int lanes = Lanes<P>::count;
  double target[lanes], x[lanes];
  for (int l = 0; l < lanes; ++l) {
    target[l] = 10 * l;
    x[l] = l + 0.5;
  }
  add_to(target, load<P>(x));
  for (int l = 0; l < lanes; ++l) EXPECT_EQ(target[l], 11 * l + 0.5);
  double one = 2;
  add_to(&one, 3.0);
  EXPECT_EQ(one, 5);
}

}  // namespace
}  // namespace softwet
