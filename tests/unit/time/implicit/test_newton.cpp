// Newton's method on a small nonlinear system with a known root, and every way it can fail.
#include <gtest/gtest.h>

#include "unit/time/cubic_equation.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Newton, ConvergesQuadratically) {
  CubicEquation cubic;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult r = newton.solve(cubic.system(x), fields, tight(), x);
  EXPECT_TRUE(r.converged) << r.refusal.text();
  EXPECT_TRUE(r.refusal.empty());
  EXPECT_LE(r.iterations, 7);
  EXPECT_LE(r.reduction, 1e-12);
  EXPECT_LT(error(x, cubic.root), 1e-11);
  EXPECT_EQ(newton.counts().newton, r.iterations);
  EXPECT_EQ(newton.counts().krylov, r.krylov);
  EXPECT_EQ(newton.counts().residuals, r.iterations + 1);
}

TEST(Newton, InexactStepsConvergeToo) {
  CubicEquation cubic;
  NewtonControl control;
  control.rtol = 1e-8;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult r = newton.solve(cubic.system(x), fields, control, x);
  EXPECT_TRUE(r.converged) << r.refusal.text();
  EXPECT_LT(error(x, cubic.root), 1e-7);
}

TEST(Newton, DifferenceProductsFindTheSameRoot) {
  CubicEquation cubic;
  NewtonControl control = tight();
  control.jacobian = JacobianKind::difference;
  control.krylov_rtol = 1e-6;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult r = newton.solve(cubic.system(x), fields, control, x);
  EXPECT_TRUE(r.converged) << r.refusal.text();
  EXPECT_LT(error(x, cubic.root), 1e-11);
  EXPECT_EQ(cubic.exact, 0);
}

// The residual is double, so its tolerance is met to the end, although each correction has seven digits only.
TEST(Newton, LinearSolvesInSinglePrecisionFindTheSameRoot) {
  CubicEquation cubic;
  NewtonControl control = tight();
  control.krylov_rtol = 1e-4;
  Newton full(alone, unknowns, unknowns, std::make_unique<NoPreconditioner>());
  Newton single(alone, unknowns, unknowns, std::make_unique<NoPreconditioner>(), LinearSolves::single);
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5)),
              y = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult expected = full.solve(cubic.system(x), fields, control, x);
  const NewtonResult found = single.solve(with_single_product(cubic, y), fields, control, y);
  EXPECT_TRUE(found.converged) << found.refusal.text();
  EXPECT_LE(found.iterations, expected.iterations + 1);
  EXPECT_LE(found.reduction, 1e-12);
  EXPECT_LT(error(y, cubic.root), 1e-11);
  EXPECT_EQ(single.counts().products, cubic.exact - full.counts().products);
}

/// Residuals with a round-off of 1e-7 that looks random.
NonlinearSystem with_round_off(CubicEquation& cubic, const Array& x) {
  NonlinearSystem system = cubic.system(x);
  system.residual = [&cubic](const Array& y, const Array& r) {
    std::vector<double> f = cubic.value(to_host(y));
    for (int i = 0; i < unknowns; ++i) f[i] += 1e-7 * std::sin(1e9 * (f[i] + i));
    Kokkos::deep_copy(r, to_device<Array>(f));
  };
  return system;
}

TEST(Newton, EndsAtTheRoundOffOfTheResidualWhereItIsGiven) {
  CubicEquation cubic;
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  Newton newton = make_newton();
  const NewtonResult untold = newton.solve(with_round_off(cubic, x), fields, tight(), x);
  EXPECT_FALSE(untold.converged);
  EXPECT_EQ(untold.refusal.cause, Refusal::newton);

  Kokkos::deep_copy(x, 0.5);
  std::vector<FieldRange> told = fields;
  for (FieldRange& f : told) f.round_off = 1e-7 * std::sqrt(0.5 * unknowns / 2);
  const NewtonResult found = newton.solve(with_round_off(cubic, x), told, tight(), x);
  EXPECT_TRUE(found.converged) << found.refusal.text();
  EXPECT_LE(found.iterations, 7);
  EXPECT_LT(error(x, cubic.root), 1e-6);
  EXPECT_GT(error(x, cubic.root), 1e-11);
}

TEST(Newton, AtTheRootNothingIsDone) {
  CubicEquation cubic;
  Newton newton = make_newton();
  const Array x = to_device<Array>(cubic.root);
  const NewtonResult r = newton.solve(cubic.system(x), fields, tight(), x);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, 0);
}

// A tolerance that lets any prediction pass still asks for one iteration, but for none at the root.
TEST(Newton, ALooseToleranceDoesNotSaveTheFirstIteration) {
  CubicEquation cubic;
  NewtonControl control = tight();
  control.atol = 1e-3;
  const std::vector<FieldRange> loose{{0, unknowns / 2, 1e3}, {unknowns / 2, unknowns, 1e3}};
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const double before = error(x, cubic.root);
  const NewtonResult r = newton.solve(cubic.system(x), loose, control, x);
  EXPECT_TRUE(r.converged) << r.refusal.text();
  EXPECT_EQ(r.iterations, 1);
  EXPECT_LT(error(x, cubic.root), 0.9 * before);

  Kokkos::deep_copy(x, to_device<Array>(cubic.root));
  EXPECT_EQ(newton.solve(cubic.system(x), loose, control, x).iterations, 0);
}

TEST(Newton, ResidualThatIsNotFinite) {
  CubicEquation cubic;
  NonlinearSystem system = cubic.system(Array());
  system.residual = [](const Array&, const Array& r) { Kokkos::deep_copy(r, std::nan("")); };
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult r = newton.solve(system, fields, tight(), x);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.refusal.cause, Refusal::not_finite);
}

TEST(Newton, InadmissibleStepsAreShortenedThenRefused) {
  CubicEquation cubic;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  NonlinearSystem system = cubic.system(x);
  int complaints = 0;
  system.complaint = [&](const Array&) { return Refusal{++complaints == 1 ? Refusal::mesh_folded : Refusal::none}; };
  EXPECT_TRUE(newton.solve(system, fields, tight(), x).converged) << "one shortened step";
  EXPECT_GT(complaints, 1);

  Kokkos::deep_copy(x, 0.5);
  system.complaint = [](const Array&) { return Refusal{Refusal::negative_density}; };
  const NewtonResult r = newton.solve(system, fields, tight(), x);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.refusal.cause, Refusal::negative_density);
  EXPECT_LT(error(x, std::vector<double>(unknowns, 0.5)), 1e-300) << "x is untouched by a refused step";
}

TEST(Newton, TooFewIterations) {
  CubicEquation cubic;
  NewtonControl control = tight();
  control.max = 2;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  const NewtonResult r = newton.solve(cubic.system(x), fields, control, x);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.iterations, 2);
  EXPECT_EQ(r.refusal.cause, Refusal::newton);
}

TEST(Newton, StalledLinearSolver) {
  CubicEquation cubic;
  Newton newton = make_newton();
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  NonlinearSystem system = cubic.system(x);
  system.product = [](const Array&, const Array& out) { Kokkos::deep_copy(out, 0.0); };
  const NewtonResult r = newton.solve(system, fields, tight(), x);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.refusal.cause, Refusal::linear_solver);
}

}  // namespace
}  // namespace softwet::testing_tools
