// Orders and stability of the Runge-Kutta schemes, on equations with a known solution.
#include "time/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "field/vector.hpp"

namespace softwet {
namespace {

/// y1' = -y1 y2, y2' = y1 y1 - cos(t) y2 - s y2: nonlinear, with time in it; -s y2 is its stiff part.
struct Toy final : Evolution {
  double stiffness;
  int calls = 0, fails_at = 0;  ///< evaluations of the stiff rates, and which of them fails
  explicit Toy(double s) : stiffness(s) {}
  int size() const override { return 2; }
  std::vector<double> gentle(double t, const std::vector<double>& y) const {
    return {-y[0] * y[1], y[0] * y[0] - std::cos(t) * y[1]};
  }
  Refusal rates(double t, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    std::vector<double> f = gentle(t, v);
    f[1] -= stiffness * v[1];
    Kokkos::deep_copy(out, to_device<Array>(f));
    return {};
  }
  Refusal gentle_rates(double t, const Array& y, const Array& out) override {
    Kokkos::deep_copy(out, to_device<Array>(gentle(t, to_host(y))));
    return {};
  }
  Refusal stiff_rates(const Array& y, const Array& out) override {
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{0, -stiffness * to_host(y)[1]}));
    return ++calls == fails_at ? Refusal{Refusal::viscous_rate} : Refusal{};
  }
  Refusal hold(const Array&) override { return {}; }
  Refusal implicit_part(double c, const Array& y, const Array& out) override {
    std::vector<double> v = to_host(y);
    v[1] /= 1 + c * stiffness;
    Kokkos::deep_copy(y, to_device<Array>(v));
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{0, -stiffness * v[1]}));
    return {};
  }
};

std::vector<double> integrate(RungeKutta& scheme, Toy& toy, int steps) {
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.3}), k("k", 2);
  const double dt = 1.0 / steps;
  for (int n = 0; n < steps; ++n) {
    scheme.treats_stiff_part() ? toy.gentle_rates(n * dt, y, k) : toy.rates(n * dt, y, k);
    EXPECT_TRUE(scheme.advance(toy, n * dt, dt, y, k).empty());
  }
  return to_host(y);
}

double error_of(const std::vector<double>& a, const std::vector<double>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

void expect_order(RungeKutta& scheme, double stiffness, int coarse, double order) {
  Toy toy(stiffness);
  SspRk3 fine(2);
  const std::vector<double> exact = integrate(fine, toy, 4000);
  const double a = error_of(integrate(scheme, toy, coarse), exact),
               b = error_of(integrate(scheme, toy, 2 * coarse), exact);
  std::printf("  %s: errors %.2e, %.2e, order %.2f\n", scheme.name(), a, b, std::log2(a / b));
  EXPECT_NEAR(std::log2(a / b), order, 0.25) << scheme.name();
}

TEST(RungeKutta, OrdersOfAccuracy) {
  SspRk3 rk3(2);
  expect_order(rk3, 0.5, 20, 3);
  ImexArs343 imex(2);
  expect_order(imex, 0.5, 20, 3);
  StrangRkl2 rkl2(2);
  rkl2.set_stiff_radius(0.5);
  expect_order(rkl2, 0.5, 40, 2);
}

// s stages bear dt r up to (s^2 + s - 2) / 2; the number of stages is the least odd one that does, with 5 % to spare.
TEST(RungeKutta, StagesOfRkl2) {
  EXPECT_EQ(StrangRkl2::stages(1, 0), 3);
  EXPECT_EQ(StrangRkl2::stages(1, 5 / 1.051), 3);
  EXPECT_EQ(StrangRkl2::stages(1, 5 / 1.049), 5);
  EXPECT_EQ(StrangRkl2::stages(0.5, 2 * 494 / 1.051), 31);
}

// The stiff part alone has a bound of dt; stages remove it, down to stages that are too few.
TEST(RungeKutta, StagesOfRkl2BearTheStiffPart) {
  StrangRkl2 rkl2(2);
  Toy toy(4000);
  rkl2.set_stiff_radius(4000);
  EXPECT_LT(std::abs(integrate(rkl2, toy, 20)[1]), 0.05) << "0.3 in the beginning";
  rkl2.set_stiff_radius(1000);
  EXPECT_FALSE(std::abs(integrate(rkl2, toy, 20)[1]) < 1e3);
}

// In any stage of either half step: a rate that could not be found is not stepped with.
TEST(RungeKutta, AFailedStageOfTheStiffPartRefusesTheStep) {
  const auto step = [](Toy& toy) {
    StrangRkl2 rkl2(2);
    rkl2.set_stiff_radius(1);
    const Array y = to_device<Array>(std::vector<double>{1.0, 0.3}), k("k", 2);
    toy.gentle_rates(0, y, k);
    return rkl2.advance(toy, 0, 0.1, y, k);
  };
  Toy whole(1);
  EXPECT_TRUE(step(whole).empty());
  EXPECT_EQ(whole.calls, 2 * StrangRkl2::stages(0.05, 1));
  for (int stage = 1; stage <= whole.calls; ++stage) {
    Toy toy(1);
    toy.fails_at = stage;
    EXPECT_EQ(step(toy).cause, Refusal::viscous_rate) << stage;
    EXPECT_EQ(toy.calls, stage) << "nothing is computed behind it";
  }
}

TEST(RungeKutta, ImplicitPartDampsAnyStiffness) {
  ImexArs343 imex(2);
  Toy toy(1e8);
  EXPECT_NEAR(integrate(imex, toy, 20)[1], 0, 1e-7);
}

/// y'' = -y as a system.
struct Oscillator final : Evolution {
  int size() const override { return 2; }
  Refusal rates(double, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{v[1], -v[0]}));
    return {};
  }
  Refusal gentle_rates(double t, const Array& y, const Array& out) override { return rates(t, y, out); }
  Refusal stiff_rates(const Array&, const Array& out) override {
    Kokkos::deep_copy(out, 0.0);
    return {};
  }
  Refusal hold(const Array&) override { return {}; }
  Refusal implicit_part(double, const Array&, const Array& out) override {
    Kokkos::deep_copy(out, 0.0);
    return {};
  }
};

/// Size of the solution after 2000 steps of size dt.
double growth(RungeKutta& scheme, double dt) {
  Oscillator oscillator;
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.0}), k("k", 2);
  for (int n = 0; n < 2000; ++n) {
    oscillator.rates(0, y, k);
    scheme.advance(oscillator, 0, dt, y, k);
  }
  return norm(alone, y);
}

TEST(RungeKutta, LimitsForOscillationsAreThoseStated) {
  SspRk3 rk3(2);
  ImexArs343 imex(2);
  StrangRkl2 rkl2(2);
  for (RungeKutta* scheme : std::initializer_list<RungeKutta*>{&rk3, &imex, &rkl2}) {
    const double limit = scheme->limit(1, true);
    EXPECT_LE(growth(*scheme, limit), 1.0) << scheme->name();
    EXPECT_GT(growth(*scheme, 1.01 * limit), 10.0) << scheme->name();
  }
}

}  // namespace
}  // namespace softwet
