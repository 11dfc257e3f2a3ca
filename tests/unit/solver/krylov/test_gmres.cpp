// Flexible restarted GMRES on small dense systems whose solution is known.
#include <gtest/gtest.h>

#include "unit/solver/dense_system.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Gmres, FindsTheSolution) {
  const Dense m(60, 4, 0.6);
  Gmres gmres(alone, 60, 60);
  Array x("x", 60);
  const KrylovResult r = gmres.solve(m.apply(), identity, to_device<Array>(m.right), x, 1e-13, 60);
  EXPECT_TRUE(r.converged);
  EXPECT_LE(r.iterations, 60);
  EXPECT_GT(r.iterations, 5);
  const std::vector<double> found = to_host(x);
  for (int i = 0; i < 60; ++i) EXPECT_NEAR(found[i], m.solution[i], 1e-11);
}

TEST(Gmres, ReportsTheTrueResidual) {
  const Dense m(60, 4, 0.6);
  for (const double tolerance : {1e-2, 1e-5, 1e-9}) {
    Gmres gmres(alone, 60, 30);
    Array x("x", 60);
    const KrylovResult r = gmres.solve(m.apply(), identity, to_device<Array>(m.right), x, tolerance, 200);
    EXPECT_TRUE(r.converged);
    EXPECT_LE(r.reduction, 1.01 * tolerance);
    EXPECT_NEAR(r.reduction, m.reduction(to_host(x)), 1e-8 * r.reduction + 1e-16);
  }
}

TEST(Gmres, RestartsAndStillConverges) {
  const Dense m(60, 4, 0.6);
  const Array b = to_device<Array>(m.right);
  Array x("x", 60);
  const KrylovResult full = Gmres(alone, 60, 60).solve(m.apply(), identity, b, x, 1e-10, 300);
  const KrylovResult cut = Gmres(alone, 60, 7).solve(m.apply(), identity, b, x, 1e-10, 300);
  EXPECT_TRUE(cut.converged);
  EXPECT_GT(cut.iterations, 7);
  EXPECT_GE(cut.iterations, full.iterations);
  EXPECT_LT(m.reduction(to_host(x)), 1.01e-10);
}

TEST(Gmres, StopsAtTheLimitWithoutClaimingSuccess) {
  const Dense m(60, 40, 0.6);
  Gmres gmres(alone, 60, 30);
  Array x("x", 60);
  const KrylovResult r = gmres.solve(m.apply(), identity, to_device<Array>(m.right), x, 1e-14, 8);
  EXPECT_EQ(r.iterations, 8);
  EXPECT_FALSE(r.converged);
  EXPECT_NEAR(r.reduction, m.reduction(to_host(x)), 1e-10);
  EXPECT_LT(r.reduction, 1);
}

TEST(Gmres, PreconditionerHelps) {
  const Dense m(60, 40, 0.6);
  const Array b = to_device<Array>(m.right);
  Array x("x", 60);
  const int bare = Gmres(alone, 60, 60).solve(m.apply(), identity, b, x, 1e-8, 200).iterations;
  const int helped = Gmres(alone, 60, 60).solve(m.apply(), m.jacobi(), b, x, 1e-8, 200).iterations;
  EXPECT_LT(2 * helped, bare);
  EXPECT_LT(m.reduction(to_host(x)), 1.01e-8);
}

// A preconditioner that changes at every call: right for a flexible method, wrong for a plain one.
TEST(Gmres, PreconditionerMayChange) {
  const Dense m(60, 4, 0.6);
  int calls = 0;
  const auto changing = [&](const Array& r, const Array& z) {
    if (++calls % 2) return m.jacobi()(r, z);
    combine(z, 0.3 * calls, r, 0);
  };
  Array x("x", 60);
  const KrylovResult r = Gmres(alone, 60, 40).solve(m.apply(), changing, to_device<Array>(m.right), x, 1e-10, 200);
  EXPECT_TRUE(r.converged);
  EXPECT_LT(m.reduction(to_host(x)), 1.01e-10);
}

TEST(Gmres, ExactPreconditionerNeedsOneIteration) {
  const Dense m(40, 4, 0.0);
  Array x("x", 40);
  const KrylovResult r = Gmres(alone, 40, 10).solve(m.apply(), m.jacobi(), to_device<Array>(m.right), x, 1e-12, 100);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, 1);
}

TEST(Gmres, ZeroRightHandSide) {
  const Dense m(40, 4, 0.3);
  Array x("x", 40);
  Kokkos::deep_copy(x, 3.0);
  const KrylovResult r = Gmres(alone, 40, 10).solve(m.apply(), identity, Array("zero", 40), x, 1e-12, 100);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(norm(alone, x), 0);
}

// A singular operator cannot be inverted: the method must say so and end.
TEST(Gmres, SingularSystemEndsWithoutSuccess) {
  const auto project = [](const Array& x, const Array& y) {
    std::vector<double> v = to_host(x);
    v[0] = 0;
    Kokkos::deep_copy(y, to_device<Array>(v));
  };
  Array x("x", 20);
  const KrylovResult r =
      Gmres(alone, 20, 10).solve(project, identity, to_device<Array>(std::vector<double>(20, 1.0)), x, 1e-10, 1000);
  EXPECT_FALSE(r.converged);
  EXPECT_LT(r.iterations, 1000);
  EXPECT_NEAR(r.reduction, 1 / std::sqrt(20.0), 1e-10);
}

}  // namespace
}  // namespace softwet::testing_tools
