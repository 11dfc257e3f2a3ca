// Orders and stability of the Runge-Kutta schemes, on equations with a known solution.
#include "time/explicit/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "field/vector.hpp"

namespace softwet {
namespace {

/// y1' = -y1 y2, y2' = y1 y1 - cos(t) y2: nonlinear, with time in it.
struct Toy final : Evolution {
  int size() const override { return 2; }
  Refusal rates(double t, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{-v[0] * v[1], v[0] * v[0] - std::cos(t) * v[1]}));
    return {};
  }
};

std::vector<double> integrate(int steps) {
  SspRk3 scheme(2);
  Toy toy;
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.3}), k("k", 2);
  const double dt = 1.0 / steps;
  for (int n = 0; n < steps; ++n) {
    toy.rates(n * dt, y, k);
    EXPECT_TRUE(scheme.advance(toy, n * dt, dt, y, k).empty());
  }
  return to_host(y);
}

double error_of(const std::vector<double>& a, const std::vector<double>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

TEST(RungeKutta, SspRk3IsOfThirdOrder) {
  const std::vector<double> exact = integrate(4000);
  EXPECT_NEAR(std::log2(error_of(integrate(20), exact) / error_of(integrate(40), exact)), 3, 0.25);
}

/// y' = -r y + y^2 without time, and how often it was asked for.
struct Decay {
  double rate;
  int calls = 0, fails_at = 0;
  Refusal operator()(const Array& y, const Array& out) {
    const double v = to_host(y)[0];
    Kokkos::deep_copy(out, -rate * v + v * v);
    return ++calls == fails_at ? Refusal{Refusal::viscous_rate} : Refusal{};
  }
};

/// Value at t = 1 from 0.5 at 0.
double decayed(double rate, double radius, int steps) {
  Rkl2 scheme(1);
  Decay decay{rate};
  const Array y("y", 1);
  Kokkos::deep_copy(y, 0.5);
  for (int n = 0; n < steps; ++n) EXPECT_TRUE(scheme.advance(std::ref(decay), 1.0 / steps, y, radius).empty());
  return to_host(y)[0];
}

TEST(RungeKutta, Rkl2IsOfSecondOrder) {
  constexpr double r = 3;
  const double exact = r / (1 + (r / 0.5 - 1) * std::exp(r));
  const double a = std::abs(decayed(r, r, 20) - exact), b = std::abs(decayed(r, r, 40) - exact);
  EXPECT_NEAR(std::log2(a / b), 2, 0.25);
}

// s stages bear dt r up to (s^2 + s - 2) / 2; the number of stages is the least odd one that does.
TEST(RungeKutta, StagesOfRkl2) {
  EXPECT_EQ(Rkl2::stages(1, 0), 3);
  EXPECT_EQ(Rkl2::stages(1, 4.99), 3);
  EXPECT_EQ(Rkl2::stages(1, 5.01), 5);
  EXPECT_EQ(Rkl2::stages(0.5, 2 * 494.9), 31);
}

TEST(RungeKutta, StagesOfRkl2BearAStiffRateAndFewerDoNot) {
  EXPECT_LT(std::abs(decayed(4000, 4000, 20)), 0.05) << "0.5 in the beginning";
  EXPECT_FALSE(std::abs(decayed(4000, 1000, 20)) < 1e3);
}

TEST(RungeKutta, AFailedStageOfRkl2RefusesTheStep) {
  const auto step = [](Decay& decay) {
    Rkl2 scheme(1);
    const Array y("y", 1);
    Kokkos::deep_copy(y, 0.5);
    return scheme.advance(std::ref(decay), 0.1, y, 1);
  };
  Decay whole{1};
  EXPECT_TRUE(step(whole).empty());
  EXPECT_EQ(whole.calls, Rkl2::stages(0.1, 1));
  for (int stage = 1; stage <= whole.calls; ++stage) {
    Decay decay{1, 0, stage};
    EXPECT_EQ(step(decay).cause, Refusal::viscous_rate) << stage;
    EXPECT_EQ(decay.calls, stage) << "nothing is computed behind it";
  }
}

/// y'' = -y as a system.
struct Oscillator final : Evolution {
  int size() const override { return 2; }
  Refusal rates(double, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{v[1], -v[0]}));
    return {};
  }
};

/// Size of the solution after 2000 steps of size dt.
double growth(double dt) {
  SspRk3 scheme(2);
  Oscillator oscillator;
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.0}), k("k", 2);
  for (int n = 0; n < 2000; ++n) {
    oscillator.rates(0, y, k);
    scheme.advance(oscillator, 0, dt, y, k);
  }
  return norm(alone, y);
}

TEST(RungeKutta, TheLimitOfSspRk3ForOscillationsIsThatStated) {
  EXPECT_LE(growth(1.73), 1.0);
  EXPECT_GT(growth(1.01 * 1.7321), 10.0);
}

}  // namespace
}  // namespace softwet
