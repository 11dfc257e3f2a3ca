// How long Newton's method keeps a preconditioner, and what it does with the answers of an old one.
#include <gtest/gtest.h>

#include "unit/time/cubic_equation.hpp"

namespace softwet::testing_tools {
namespace {

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
  Newton dear(alone, unknowns, unknowns, std::make_unique<Counting>(builds, 1e9));
  EXPECT_EQ(solve(dear), 1);
  EXPECT_EQ(solve(dear), 1);
  dear.forget_preconditioner();
  EXPECT_EQ(solve(dear), 2);
  Newton free(alone, unknowns, unknowns, std::make_unique<Counting>(builds, 0));  // a new one for every linear solve
  EXPECT_GT(solve(free), 4);
}

TEST(Newton, ALaggedPreconditionerThatFailsIsReplacedAtOnce) {
  CubicEquation cubic;
  int builds = 0;
  Newton newton(alone, unknowns, unknowns, std::make_unique<Counting>(builds));
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

/// Newton's method on diag(d) (x - 1) = 0, twice: with d = 1 + i everywhere, then with five times that on the second
/// and the third quarter. Returns the number of iterations of GMRES of the second solve.
int iterations_of_second_solve(LinearSolves precision, const SolidPart& first, const SolidPart& second) {
  const Array diagonal("diagonal", unknowns), x("x", unknowns);
  Newton newton(alone, unknowns, unknowns, std::make_unique<DiagonalInverse>(diagonal), precision);
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

/// Windows of four digits that take so many iterations each.
void add_windows(Wear& wear, std::initializer_list<int> iterations) {
  for (int n : iterations) wear.add({n, 1e-4, true});
}

TEST(Wear, CountsIterationsAboveAThirdMoreThanTheBestWindow) {
  Wear wear;
  EXPECT_FALSE(wear.due(4));
  EXPECT_GT(wear.patience(1e-2, 40), 1000000);  // nothing is known yet
  wear.add({20, 1e-1, true});                   // a dear solve and a cheap one make one window
  wear.add({20, 1e-3, true});
  EXPECT_EQ(wear.patience(1e-3, 40), 39 + 10 + 1);  // 13 for each digit, a quarter of the cost, and the one too many
  add_windows(wear, {52});
  EXPECT_FALSE(wear.due(4));
  add_windows(wear, {55});  // 3 too many
  EXPECT_TRUE(wear.due(12));
  EXPECT_FALSE(wear.due(13));
  add_windows(wear, {4});  // a good day earns nothing back; from now on it is the measure
  EXPECT_TRUE(wear.due(12));
  add_windows(wear, {10});  // 4.8 too many
  EXPECT_TRUE(wear.due(31));
  EXPECT_FALSE(wear.due(32));
  wear.renew();
  EXPECT_FALSE(wear.due(4));
}

/// Each begins where the one before has ended: the systems have become harder, and a new preconditioner is no help.
TEST(Wear, KeepsPreconditionersLongerWhereNewOnesAreNoBetter) {
  Wear wear;
  int times = 1;
  for (int first : {40, 60, 90, 130}) {
    const int last = 13 * first / 10 + 10;
    add_windows(wear, {first, last});  // 10 too many
    EXPECT_TRUE(wear.due(40.0 / times)) << times;
    EXPECT_FALSE(wear.due(41.0 / times)) << times;
    wear.renew();
    times = std::min(4, 2 * times);
  }
  add_windows(wear, {30, 49});  // this one is better than those before: 10 too many
  EXPECT_TRUE(wear.due(40));
  EXPECT_FALSE(wear.due(41));
}

}  // namespace
}  // namespace softwet::testing_tools
