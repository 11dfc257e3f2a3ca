// GMRES at the limits of round-off: single precision, cancellation, and the sums that it needs.
#include <gtest/gtest.h>

#include "cli/core/kernel_counts.hpp"
#include "unit/solver/dense_system.hpp"

namespace softwet::testing_tools {
namespace {

// Vectors in single precision lose 1e-7 of the right-hand side in each iteration: 1e-4 is far above that.
TEST(Gmres, ReachesTheSameToleranceInSinglePrecision) {
  const Dense m(60, 4, 0.6);
  for (const double tolerance : {1e-1, 1e-2, 1e-4}) {
    const Array b = to_device<Array>(m.right), x("x", 60);
    const KrylovResult full = Gmres(alone, 60, 30).solve(m.apply(), identity, b, x, tolerance, 200);
    const ArrayOf<float> single_b("b", 60), single_x("x", 60);
    convert(single_b, b);
    const auto copy = [](const ArrayOf<float>& r, const ArrayOf<float>& z) { Kokkos::deep_copy(z, r); };
    const KrylovResult single =
        GmresOf<float>(alone, 60, 30).solve(m.apply_single(), copy, single_b, single_x, tolerance, 200);
    EXPECT_TRUE(single.converged);
    EXPECT_EQ(single.iterations, full.iterations);
    convert(x, single_x);
    EXPECT_LE(m.reduction(to_host(x)), 1.02 * tolerance);
    EXPECT_NEAR(single.reduction, m.reduction(to_host(x)), 1e-6);
  }
}

TEST(Gmres, SinglePrecisionEndsAtItsRoundOffWithoutClaimingSuccess) {
  const Dense m(60, 4, 0.6);
  const ArrayOf<float> b("b", 60), x("x", 60);
  convert(b, to_device<Array>(m.right));
  const auto copy = [](const ArrayOf<float>& r, const ArrayOf<float>& z) { Kokkos::deep_copy(z, r); };
  const KrylovResult r = GmresOf<float>(alone, 60, 60).solve(m.apply_single(), copy, b, x, 1e-12, 10000);
  EXPECT_FALSE(r.converged);
  EXPECT_LT(r.iterations, 1000);
  EXPECT_LT(r.reduction, 1e-5);
}

// Directions that are nearly parallel: the answer is a small difference of large multiples of them, and so is the
// residual that follows from their products. It must not be believed where round-off is as large.
TEST(Gmres, DoesNotBelieveAResidualThatRoundOffHides) {
  const Dense m(60, 4, 0.6);
  const ArrayOf<float> b("b", 60), x("x", 60);
  convert(b, to_device<Array>(m.right));
  const std::vector<double> common(60, 1.0);
  for (const double share : {1e2, 1e3, 1e4, 1e5, 1e6}) {
    const auto parallel = [&](const ArrayOf<float>& r, const ArrayOf<float>& z) {
      convert(z, to_device<Array>(common));
      combine(z, 1.0, r, share);
    };
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
      int products = 0;
      const auto apply = [&](const ArrayOf<float>& z, const ArrayOf<float>& out) {
        ++products;
        m.apply_single()(z, out);
      };
      const KrylovResult r = GmresOf<float>(alone, 60, 60).solve(apply, parallel, b, x, tolerance, 120);
      const Array wide("wide", 60);
      convert(wide, x);
      const double actual = m.reduction(to_host(wide));
      EXPECT_NEAR(r.reduction, actual, 0.02 * actual) << share << " " << tolerance;
      EXPECT_TRUE(!r.converged || actual <= 1.03 * tolerance) << share << " " << tolerance << " " << actual;
    }
  }
}

TEST(Gmres, OrdinaryConvergenceNeedsNoProductToBeSeen) {
  const Dense m(60, 4, 0.6);
  int products = 0;
  const auto apply = [&](const Array& z, const Array& out) {
    ++products;
    m.apply()(z, out);
  };
  Array x("x", 60);
  const KrylovResult r = Gmres(alone, 60, 60).solve(apply, identity, to_device<Array>(m.right), x, 1e-4, 100);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(products, r.iterations);
}

// Most of each product lies along the vectors before it: without a second pass they would not stay orthogonal.
TEST(Gmres, StaysOrthogonalWhereProductsAreAlmostParallel) {
  const Dense m(60, 1e-3, 1e-4);
  Array x("x", 60);
  const KrylovResult r = Gmres(alone, 60, 60).solve(m.apply(), identity, to_device<Array>(m.right), x, 1e-13, 60);
  EXPECT_TRUE(r.converged);
  EXPECT_LE(r.iterations, 6);
  EXPECT_LT(m.reduction(to_host(x)), 1.01e-13);
}

/// y = A x with a nonsymmetric band, by one kernel.
template <class Real>
void multiply_band(const ArrayOf<Real>& x, const ArrayOf<Real>& y) {
  const int n = static_cast<int>(x.extent(0));
  Kokkos::parallel_for(
      "band", Items(0, n), KOKKOS_LAMBDA(int i) {
        y(i) = (1 + Real(i) / n) * x(i) + Real(0.8) * x((i + 1) % n) - Real(0.3) * x((i + n - 7) % n);
      });
}

// The second pass of a vector comes with the first one of the next vector. In single precision most vectors need one.
TEST(Gmres, BringsOneSetOfSumsToTheHostInEachIteration) {
  const int n = 4000;
  std::vector<double> right(n);
  for (int i = 0; i < n; ++i) right[i] = std::sin(0.37 * i) + std::sin(1e-4 * i * i);
  const Array b = to_device<Array>(right), x("x", n), y("y", n);
  const ArrayOf<float> single_b("b", n), single_x("x", n);
  convert(single_b, b);
  const auto copy = [](const auto& r, const auto& z) { Kokkos::deep_copy(Exec(), z, r); };
  const KrylovResult full = Gmres(alone, n, 60).solve(multiply_band<double>, copy, b, y, 1e-5, 60);
  GmresOf<float> gmres(alone, n, 60);
  KernelCounter counter;
  const KrylovResult single = gmres.solve(multiply_band<float>, copy, single_b, single_x, 1e-5, 60);
  const KernelCounts counts = counter.stop();
  EXPECT_TRUE(single.converged);
  EXPECT_EQ(single.iterations, full.iterations);
  EXPECT_GT(single.iterations, 20);
  // Besides come the norms of b and of the residual, and the second pass of the last vector, or of two where the first
  // one turns out not to be the last.
  EXPECT_LE(counts.waits, single.iterations + 4);
  EXPECT_GE(counts.waits, single.iterations);
  convert(x, single_x);
  multiply_band<double>(x, y);
  add_scaled(y, 0, -1, b);
  EXPECT_NEAR(norm(alone, y) / norm(alone, b), single.reduction, 0.02 * single.reduction);
}

// Weights of the norm do what the same weights of the rows do.
TEST(Gmres, WeightsAreThoseOfRows) {
  const Dense m(60, 4, 0.6);
  RangeFactors weights;
  weights.add(0, 17, 1e6);
  weights.add(20, 41, 1e-4);
  Dense scaled = m;
  for (int i = 0; i < 60; ++i) {
    const double root = std::sqrt(weights.at(i));
    for (int j = 0; j < 60; ++j) scaled.a[i * 60 + j] *= root;
    scaled.right[i] *= root;
  }
  const auto unscaled = [&](const Array& r, const Array& z) {
    std::vector<double> v = to_host(r);
    for (int i = 0; i < 60; ++i) v[i] /= std::sqrt(weights.at(i));
    Kokkos::deep_copy(z, to_device<Array>(v));
  };
  for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
    Array x("x", 60), y("y", 60);
    const KrylovResult one =
        Gmres(alone, 60, 60).solve(m.apply(), identity, to_device<Array>(m.right), x, tolerance, 60, weights);
    const KrylovResult other =
        Gmres(alone, 60, 60).solve(scaled.apply(), unscaled, to_device<Array>(scaled.right), y, tolerance, 60);
    EXPECT_EQ(one.iterations, other.iterations);
    EXPECT_NEAR(one.reduction, other.reduction, 1e-6 * one.reduction);
    const std::vector<double> a = to_host(x), b = to_host(y);
    for (int i = 0; i < 60; ++i) EXPECT_NEAR(a[i], b[i], 1e-7) << i;
  }
}

}  // namespace
}  // namespace softwet::testing_tools
