// The radius of symmetric operators whose largest eigenvalues lie close together, where power iteration stops too early.
#include "time/stiff_radius.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "time/power_iteration.hpp"

namespace softwet {
namespace {

/// -M^{-1} K of n linear elements on [0, 1] with ends that are held, M lumped with a weight that falls from 1 to `least`.
struct Chain {
  std::vector<double> mass;

  Chain(int n, double least) : mass(n) {
    for (int i = 0; i < n; ++i) mass[i] = std::pow(least, static_cast<double>(i) / (n - 1));
  }
  std::vector<double> stiffness(const std::vector<double>& z) const {
    std::vector<double> k(z.size());
    for (std::size_t i = 0; i < z.size(); ++i)
      k[i] = 2 * z[i] - (i > 0 ? z[i - 1] : 0) - (i + 1 < z.size() ? z[i + 1] : 0);
    return k;
  }
  Refusal operator()(const Array& z, const Array& out) const {
    std::vector<double> r = stiffness(to_host(z));
    for (std::size_t i = 0; i < r.size(); ++i) r[i] /= -mass[i];
    Kokkos::deep_copy(out, to_device<Array>(r));
    return {};
  }
  double quotient(const Array& a) const {
    const std::vector<double> z = to_host(a), k = stiffness(z);
    double power = 0, square = 0;
    for (std::size_t i = 0; i < z.size(); ++i) power += z[i] * k[i], square += mass[i] * z[i] * z[i];
    return power / square;
  }
  /// The largest eigenvalue, by Sturm sequences.
  double largest() const {
    double low = 0, high = 4 / *std::min_element(mass.begin(), mass.end());
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      int below = 0;
      double pivot = 1;
      for (std::size_t i = 0; i < mass.size(); ++i) {
        pivot = 2 - middle * mass[i] - (i > 0 ? 1 / pivot : 0);
        below += pivot < 0 ? 1 : 0;
      }
      (below < static_cast<int>(mass.size()) ? low : high) = middle;
    }
    return high;
  }
};

double measured(const Chain& chain, StiffRadius& stiff) {
  EXPECT_TRUE(stiff.measure(chain, [&](const Array& z) { return chain.quotient(z); }).empty());
  return stiff.radius();
}

TEST(StiffRadius, IsNotTooSmallWhereEigenvaluesLieCloseTogether) {
  for (const double least : {1.0, 0.5, 0.01}) {
    const Chain chain(2000, least);
    StiffRadius stiff(alone, 2000);
    const double radius = measured(chain, stiff), exact = chain.largest();
    EXPECT_LE(radius, (1 + 1e-9) * exact) << least;
    EXPECT_GE(radius, 0.99 * exact) << least;
    PowerIteration power(alone, 2000);
    power.measure([&](const Array& z, const Array& out) { return chain(z, out).empty(); });
    std::printf("  least mass %g: %.4f of the radius, power iteration %.4f\n", least, radius / exact,
                power.radius() / exact);
  }
}

// What is lighter than when the radius was measured is noticed without a new measurement.
TEST(StiffRadius, FollowsAnOperatorThatBecomesStiffer) {
  Chain chain(100, 0.1);
  StiffRadius stiff(alone, 100);
  const double before = measured(chain, stiff);
  for (double& m : chain.mass) m *= 0.8;
  stiff.follow([&](const Array& z) { return chain.quotient(z); });
  EXPECT_NEAR(stiff.radius(), before / 0.8, 1e-9 * before);
  for (double& m : chain.mass) m *= 2;
  stiff.follow([&](const Array& z) { return chain.quotient(z); });
  EXPECT_NEAR(stiff.radius(), before / 0.8, 1e-9 * before) << "it does not fall until it is measured";
}

TEST(StiffRadius, NothingStiffHasNoRadius) {
  StiffRadius stiff(alone, 10);
  const auto none = [](const Array&, const Array& out) {
    Kokkos::deep_copy(out, 0.0);
    return Refusal{};
  };
  EXPECT_TRUE(stiff.measure(none, [](const Array&) { return 0.0; }).empty());
  EXPECT_EQ(stiff.radius(), 0);
}

// A product that could not be found ends the measurement, in the first products and in the filters behind them.
TEST(StiffRadius, AFailedProductIsTold) {
  const Chain chain(100, 0.1);
  for (const int fails_at : {1, 6, 7, 20, 40}) {
    StiffRadius stiff(alone, 100);
    int calls = 0;
    const auto apply = [&](const Array& z, const Array& out) {
      return ++calls == fails_at ? Refusal{Refusal::viscous_rate} : chain(z, out);
    };
    EXPECT_EQ(stiff.measure(apply, [&](const Array& z) { return chain.quotient(z); }).cause, Refusal::viscous_rate);
    EXPECT_EQ(calls, fails_at);
  }
}

}  // namespace
}  // namespace softwet
