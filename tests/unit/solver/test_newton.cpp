// Newton's method on a small nonlinear system with a known root, and every way it can fail.
#include "solver/newton.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

constexpr int unknowns = 24;

/// f_i = x_i^3 + 4 x_i + x_{i-1} x_{i+1} - b_i, root known.
struct CubicEquation {
  std::vector<double> root, right;
  int exact = 0;

  CubicEquation() : root(unknowns), right(unknowns, 0.0) {
    for (int i = 0; i < unknowns; ++i) root[i] = std::sin(1.0 + i);
    right = value(root);
  }
  std::vector<double> value(const std::vector<double>& x) const {
    std::vector<double> f(unknowns);
    for (int i = 0; i < unknowns; ++i)
      f[i] = x[i] * x[i] * x[i] + 4 * x[i] + x[(i + unknowns - 1) % unknowns] * x[(i + 1) % unknowns] - right[i];
    return f;
  }
  std::vector<double> slope(const std::vector<double>& x, const std::vector<double>& z) const {
    std::vector<double> d(unknowns);
    for (int i = 0; i < unknowns; ++i) {
      const int a = (i + unknowns - 1) % unknowns, b = (i + 1) % unknowns;
      d[i] = (3 * x[i] * x[i] + 4) * z[i] + z[a] * x[b] + x[a] * z[b];
    }
    return d;
  }
  NonlinearSystem system(const Array& x) {
    return {[this](const Array& y, const Array& r) { Kokkos::deep_copy(r, to_device<Array>(value(to_host(y)))); },
            [this, x](const Array& z, const Array& out) {
              ++exact;
              Kokkos::deep_copy(out, to_device<Array>(slope(to_host(x), to_host(z))));
            },
            [](const StencilValues&) {}, [](const Array&) { return Refusal{}; }};
  }
};

/// The same system with a product whose vectors are in single precision.
NonlinearSystem with_single_product(CubicEquation& cubic, const Array& x) {
  NonlinearSystem system = cubic.system(x);
  system.single_product = [product = std::exchange(system.product, nullptr)](const ArrayOf<float>& z,
                                                                             const ArrayOf<float>& out) {
    const Array wide("wide", unknowns), result("result", unknowns);
    convert(wide, z);
    product(wide, result);
    convert(out, result);
  };
  return system;
}

Newton make_newton() { return Newton(unknowns, unknowns, std::make_unique<NoPreconditioner>()); }
const std::vector<FieldRange> fields{{0, unknowns / 2, 1e-14}, {unknowns / 2, unknowns, 1e-14}};

NewtonControl tight() {
  NewtonControl c;
  c.rtol = 1e-12;
  c.krylov_rtol = 1e-10;
  c.max = 12;
  return c;
}

double error(const Array& x, const std::vector<double>& root) {
  const std::vector<double> found = to_host(x);
  double e = 0;
  for (int i = 0; i < unknowns; ++i) e = std::max(e, std::abs(found[i] - root[i]));
  return e;
}

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
  Newton full(unknowns, unknowns, std::make_unique<NoPreconditioner>());
  Newton single(unknowns, unknowns, std::make_unique<NoPreconditioner>(), LinearSolves::single);
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

TEST(Newton, EndsAtTheRoundOffOfTheResidualWhereItIsTold) {
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

/// Counts its builds.
class Counting final : public Preconditioner {
 public:
  explicit Counting(int& builds, double cost = 25) : builds_(builds), cost_(cost) {}
  void build(const Jacobian&) override { ++builds_; }
  void apply(const ConstArray& r, const Array& z) override { Kokkos::deep_copy(z, r); }
  std::string name() const override { return "counting"; }
  double bytes() const override { return 0; }
  double build_cost() const override { return cost_; }

 private:
  int& builds_;
  double cost_;
};

TEST(Newton, PreconditionerIsKeptUntilItHasCostABuild) {
  CubicEquation cubic;
  int builds = 0;
  const auto solve = [&](Newton& newton) {
    const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
    EXPECT_TRUE(newton.solve(cubic.system(x), fields, tight(), x).converged);
    return builds;
  };
  Newton dear(unknowns, unknowns, std::make_unique<Counting>(builds, 1e9));
  EXPECT_EQ(solve(dear), 1);
  EXPECT_EQ(solve(dear), 1);
  dear.forget_preconditioner();
  EXPECT_EQ(solve(dear), 2);
  Newton free(unknowns, unknowns, std::make_unique<Counting>(builds, 0));  // a new one for every linear solve
  EXPECT_GT(solve(free), 4);
}

TEST(Newton, ALaggedPreconditionerThatFailsIsReplacedAtOnce) {
  CubicEquation cubic;
  int builds = 0;
  Newton newton(unknowns, unknowns, std::make_unique<Counting>(builds));
  NewtonControl control = tight();
  control.krylov_rtol = 1e-2;
  control.rtol = 1e-6;
  const Array x = to_device<Array>(std::vector<double>(unknowns, 0.5));
  EXPECT_TRUE(newton.solve(cubic.system(x), fields, control, x).converged);
  control.krylov_max = 1;  // no linear solve gets anywhere
  Kokkos::deep_copy(x, 0.5);
  newton.solve(cubic.system(x), fields, control, x);
  EXPECT_GT(builds, 1);
}

/// An exact inverse of a diagonal, which remembers the diagonal of its build.
class DiagonalInverse final : public Preconditioner {
 public:
  explicit DiagonalInverse(const Array& diagonal) : diagonal_(diagonal), built_("built", unknowns) {}
  void build(const Jacobian&) override { Kokkos::deep_copy(built_, diagonal_); }
  void apply(const ConstArray& r, const Array& z) override {
    const auto residual = to_host(r), diagonal = to_host(built_);
    std::vector<double> answer(unknowns);
    for (int i = 0; i < unknowns; ++i) answer[i] = residual[i] / diagonal[i];
    Kokkos::deep_copy(z, to_device<Array>(answer));
  }
  std::string name() const override { return "diagonal"; }
  double bytes() const override { return 0; }
  double build_cost() const override { return 100; }

 private:
  Array diagonal_, built_;
};

/// Newton's method on diag(d) (x - 1) = 0, twice: with d = 1 + i everywhere, then with five times that on the second and the
/// third quarter. Returns the number of iterations of GMRES of the second solve.
int iterations_of_second_solve(LinearSolves precision, const SolidPart& first, const SolidPart& second) {
  const Array diagonal("diagonal", unknowns), x("x", unknowns);
  Newton newton(unknowns, unknowns, std::make_unique<DiagonalInverse>(diagonal), precision);
  NonlinearSystem system{[&](const Array& y, const Array& r) {
                           const auto at = to_host(y), d = to_host(diagonal);
                           std::vector<double> value(unknowns);
                           for (int i = 0; i < unknowns; ++i) value[i] = d[i] * (at[i] - 1);
                           Kokkos::deep_copy(r, to_device<Array>(value));
                         },
                         [&](const Array& z, const Array& out) {
                           const auto along = to_host(z), d = to_host(diagonal);
                           std::vector<double> value(unknowns);
                           for (int i = 0; i < unknowns; ++i) value[i] = d[i] * along[i];
                           Kokkos::deep_copy(out, to_device<Array>(value));
                         },
                         [](const StencilValues&) {}, [](const Array&) { return Refusal{}; }};
  system.single_product = [&](const ArrayOf<float>& z, const ArrayOf<float>& out) {
    const Array wide("wide", unknowns), result("result", unknowns);
    convert(wide, z);
    system.product(wide, result);
    convert(out, result);
  };
  NewtonControl control;
  control.krylov_rtol = 1e-4;
  int iterations = 0;
  for (const SolidPart* solid : {&first, &second}) {
    std::vector<double> d(unknowns);
    for (int i = 0; i < unknowns; ++i) {
      const bool grows = solid == &second && i >= unknowns / 4 && i < 3 * unknowns / 4;
      d[i] = (1 + i) * (grows ? 5 : 1);
    }
    Kokkos::deep_copy(diagonal, to_device<Array>(d));
    Kokkos::deep_copy(x, 0.0);
    system.solid = *solid;
    const NewtonResult r = newton.solve(system, fields, control, x);
    EXPECT_TRUE(r.converged);
    EXPECT_EQ(newton.counts().builds, 1);
    EXPECT_LT(error(x, std::vector<double>(unknowns, 1.0)), 1e-4);
    iterations = r.krylov;
  }
  return iterations;
}

TEST(Newton, AnswersOfALaggedPreconditionerAreFittedToTheSolid) {
  const std::vector<SolidPart::Range> where{{unknowns / 4, unknowns / 2}, {unknowns / 2, 3 * unknowns / 4}};
  for (const LinearSolves precision : {LinearSolves::full, LinearSolves::single}) {
    EXPECT_EQ(iterations_of_second_solve(precision, {where, 2}, {where, 10}), 1);
    EXPECT_GT(iterations_of_second_solve(precision, {where, 2}, {where, 2}), 1);
    EXPECT_GT(iterations_of_second_solve(precision, {}, {}), 1);
  }
}

TEST(Wear, CountsIterationsAboveTheFirstRatePerDigit) {
  Wear wear;
  wear.add({4, 1e-2, true});  // two iterations per digit
  EXPECT_DOUBLE_EQ(wear.excess(), 0);
  wear.add({8, 1e-4, true});
  EXPECT_NEAR(wear.excess(), 0, 1e-12);
  wear.add({7, 1e-2, true});
  EXPECT_NEAR(wear.excess(), 3, 1e-12);
  wear.add({1, 1e-2, true});  // a good day earns nothing back
  EXPECT_NEAR(wear.excess(), 3, 1e-12);
  EXPECT_EQ(wear.patience(1e-3, 10), 6 + 7 + 1);  // three digits, what is left of the cost, and the one too many
  wear.renew();
  EXPECT_DOUBLE_EQ(wear.excess(), 0);
}

}  // namespace
}  // namespace softwet
