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
  explicit Toy(double s) : stiffness(s) {}
  int size() const override { return 2; }
  std::vector<double> gentle(double t, const std::vector<double>& y) const {
    return {-y[0] * y[1], y[0] * y[0] - std::cos(t) * y[1]};
  }
  std::string rates(double t, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    std::vector<double> f = gentle(t, v);
    f[1] -= stiffness * v[1];
    Kokkos::deep_copy(out, to_device<Array>(f));
    return "";
  }
  std::string gentle_rates(double t, const Array& y, const Array& out) override {
    Kokkos::deep_copy(out, to_device<Array>(gentle(t, to_host(y))));
    return "";
  }
  std::string implicit_part(double c, const Array& y, const Array& out) override {
    std::vector<double> v = to_host(y);
    v[1] /= 1 + c * stiffness;
    Kokkos::deep_copy(y, to_device<Array>(v));
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{0, -stiffness * v[1]}));
    return "";
  }
};

std::vector<double> integrate(RungeKutta& scheme, Toy& toy, int steps) {
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.3}), k("k", 2);
  const double dt = 1.0 / steps;
  for (int n = 0; n < steps; ++n) {
    scheme.treats_stiff_part() ? toy.gentle_rates(n * dt, y, k) : toy.rates(n * dt, y, k);
    EXPECT_EQ(scheme.advance(toy, n * dt, dt, y, k), "");
  }
  return to_host(y);
}

double error(const std::vector<double>& a, const std::vector<double>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

void expect_order(RungeKutta& scheme, double stiffness, int coarse, double order) {
  Toy toy(stiffness);
  SspRk3 fine(2);
  const std::vector<double> exact = integrate(fine, toy, 4000);
  const double a = error(integrate(scheme, toy, coarse), exact), b = error(integrate(scheme, toy, 2 * coarse), exact);
  std::printf("  %s: errors %.2e, %.2e, order %.2f\n", scheme.name(), a, b, std::log2(a / b));
  EXPECT_NEAR(std::log2(a / b), order, 0.25) << scheme.name();
}

TEST(RungeKutta, OrdersOfAccuracy) {
  SspRk3 rk3(2);
  expect_order(rk3, 0.5, 20, 3);
  ImexArs343 imex(2);
  expect_order(imex, 0.5, 20, 3);
}

TEST(RungeKutta, ImplicitPartDampsAnyStiffness) {
  ImexArs343 imex(2);
  Toy toy(1e8);
  EXPECT_NEAR(integrate(imex, toy, 20)[1], 0, 1e-7);
}

/// y' = e^(i angle) y as a system: an oscillation at 90 degrees, a decay at 180.
struct Spiral final : Evolution {
  double angle;
  explicit Spiral(double a) : angle(a) {}
  int size() const override { return 2; }
  std::string rates(double, const Array& y, const Array& out) override {
    const std::vector<double> v = to_host(y);
    const double a = std::cos(angle), b = std::sin(angle);
    Kokkos::deep_copy(out, to_device<Array>(std::vector<double>{a * v[0] - b * v[1], b * v[0] + a * v[1]}));
    return "";
  }
  std::string gentle_rates(double t, const Array& y, const Array& out) override { return rates(t, y, out); }
  std::string implicit_part(double, const Array&, const Array& out) override {
    Kokkos::deep_copy(out, 0.0);
    return "";
  }
};

/// Size of the solution after 1000 steps of size dt.
double growth(RungeKutta& scheme, double angle, double dt) {
  Spiral spiral(angle);
  const Array y = to_device<Array>(std::vector<double>{1.0, 0.0}), k("k", 2);
  for (int n = 0; n < 1000; ++n) {
    spiral.rates(0, y, k);
    scheme.advance(spiral, 0, dt, y, k);
  }
  return norm(y);
}

/// The limit holds for eigenvalues in all directions of the left half plane, and no longer one would.
TEST(RungeKutta, LimitsAreThoseOfTheWorstDirection) {
  SspRk3 rk3(2);
  ImexArs343 imex(2);
  for (RungeKutta* scheme : {static_cast<RungeKutta*>(&rk3), static_cast<RungeKutta*>(&imex)}) {
    const double limit = scheme->limit(1);
    double worst = 0;
    for (int degrees = 90; degrees <= 180; degrees += 5) {
      EXPECT_LE(growth(*scheme, degrees * M_PI / 180, limit), 1.0) << scheme->name() << " at " << degrees;
      worst = std::max(worst, growth(*scheme, degrees * M_PI / 180, 1.01 * limit));
    }
    EXPECT_GT(worst, 10.0) << scheme->name();
  }
}

}  // namespace
}  // namespace softwet
