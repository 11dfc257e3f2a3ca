// The largest stable step on linear equations whose modes are known, against the stability polynomials.
#include "time/stability_limit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "field/vector.hpp"

namespace softwet {
namespace {

/// Pairs of modes, z = (p, v) each: p' = w v, v' = -w p - gentle v - stiff v.
struct Mode {
  double w, gentle, stiff;
};

struct Modes final : Evolution {
  std::vector<Mode> modes;
  explicit Modes(std::vector<Mode> m) : modes(std::move(m)) {}
  int size() const override { return 2 * static_cast<int>(modes.size()); }

  template <class Pair>
  void write(const Array& y, const Array& out, const Pair& pair) const {
    const std::vector<double> z = to_host(y);
    std::vector<double> r(z.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const std::array<double, 2> a = pair(modes[i], z[2 * i], z[2 * i + 1]);
      r[2 * i] = a[0], r[2 * i + 1] = a[1];
    }
    Kokkos::deep_copy(out, to_device<Array>(r));
  }
  using Two = std::array<double, 2>;
  Refusal rates(double, const Array& y, const Array& out) override {
    write(y, out, [](const Mode& m, double p, double v) { return Two{m.w * v, -m.w * p - (m.gentle + m.stiff) * v}; });
    return {};
  }
  Refusal gentle_rates(double, const Array& y, const Array& out) override {
    write(y, out, [](const Mode& m, double p, double v) { return Two{m.w * v, -m.w * p - m.gentle * v}; });
    return {};
  }
  Refusal stiff_rates(const Array& y, const Array& out) override {
    write(y, out, [](const Mode& m, double, double v) { return Two{0, -m.stiff * v}; });
    return {};
  }
  Refusal hold(const Array&) override { return {}; }
  Refusal implicit_part(double c, const Array& y, const Array& out) override {
    const Array given = to_device<Array>(to_host(y));
    write(given, y, [c](const Mode& m, double p, double v) { return Two{p, v / (1 + c * m.stiff)}; });
    return stiff_rates(y, out);
  }
};

double found(RungeKutta& scheme, std::vector<Mode> modes, double near) {
  Modes f(std::move(modes));
  return StabilityLimit(alone, f.size()).search(scheme, f, 0, near);
}

/// At most the limit, and at most 5 % less.
void expect_limit(double found, double limit) {
  EXPECT_LE(found, limit);
  EXPECT_GE(found, 0.95 * limit);
}

/// Largest dt for which the polynomial sum of (dt l)^k / k!, k <= degree, stays within the unit circle.
double limit_of(std::complex<double> l, int degree) {
  for (double dt = 0.01;; dt += 0.001) {
    std::complex<double> sum = 1, term = 1;
    for (int k = 1; k <= degree; ++k) sum += term *= dt * l / static_cast<double>(k);
    if (std::abs(sum) > 1) return dt;
  }
}

/// The eigenvalue of a mode without a stiff part.
std::complex<double> eigenvalue(const Mode& m) {
  const std::complex<double> half = 0.5 * m.gentle;
  return -half - std::sqrt(half * half - m.w * m.w);
}

// Near the imaginary axis, near the real one and in between, where the scheme bears more than on both.
TEST(StabilityLimit, IsThatOfTheStabilityPolynomial) {
  const Mode slow{0.3, 0.1, 0};
  for (const double damping : {0.0, 0.3, 0.8, 1.5, 2.5}) {
    const Mode mode{1, damping, 0};
    SspRk3 rk3(4);
    ImexArs343 imex(4);
    expect_limit(found(rk3, {mode, slow}, 1.7), limit_of(eigenvalue(mode), 3));
    expect_limit(found(imex, {mode, slow}, 2.7), limit_of(eigenvalue(mode), 4));
  }
}

// The mode with the largest eigenvalue is not the one that limits the step: it lies where the scheme bears more.
TEST(StabilityLimit, IsThatOfTheModeWhichGrowsFirst) {
  SspRk3 rk3(4);
  const double limit = limit_of({0, 1}, 3);
  EXPECT_GT(limit_of(eigenvalue({1.1, 1, 0}), 3), 1.05 * limit);
  expect_limit(found(rk3, {{1.1, 1, 0}, {1, 0, 0}}, 1.5), limit);
}

// Without steps near the limit to begin with.
TEST(StabilityLimit, IsFoundFromStepsFarFromIt) {
  SspRk3 rk3(2);
  for (const double near : {0.3, 1.0, 5.0}) expect_limit(found(rk3, {{1, 0, 0}}, near), limit_of({0, 1}, 3));
}

// A stiff part treated apart damps the oscillation. What an instability of the equations themselves does, without turning,
// is no limit of a scheme.
TEST(StabilityLimit, CountsTheDampingOfTheStiffPart) {
  ImexArs343 imex(4);
  StrangRkl2 rkl2(4);
  rkl2.set_stiff_radius(1);
  for (RungeKutta* scheme : std::initializer_list<RungeKutta*>{&imex, &rkl2}) {
    const double free = found(*scheme, {{1, 0, 0}, {0.2, 0, 0}}, 2);
    const double damped = found(*scheme, {{1, 0, 1}, {0.2, 0, 1}}, 2);
    EXPECT_GT(damped, 1.05 * free) << scheme->name();
  }
  SspRk3 rk3(4);
  expect_limit(found(rk3, {{1, 0, 0}, {1e-3, -0.02, 0}}, 2), limit_of({0, 1}, 3));
}

// Equations that have become stiffer or softer by some per cent since the search.
TEST(StabilityLimit, FollowsEquationsThatChangeALittle) {
  for (const double factor : {0.97, 1.0, 1.05}) {
    SspRk3 rk3(4);
    Modes f({{1, 0.3, 0}, {0.3, 0.1, 0}});
    StabilityLimit stability(alone, f.size());
    ASSERT_GT(stability.search(rk3, f, 0, 1.7), 0);
    for (Mode& m : f.modes) m = {factor * m.w, factor * m.gentle, 0};
    const double limit = limit_of(eigenvalue(f.modes[0]), 3), found = stability.follow(rk3, f, 0);
    EXPECT_LE(found, limit) << factor;
    EXPECT_GE(found, 0.9 * limit) << factor;
  }
}

TEST(StabilityLimit, NoneIsFoundWhereNothingLimits) {
  SspRk3 rk3(2);
  EXPECT_EQ(found(rk3, {{0, 0, 0}}, 1), 0);
}

}  // namespace
}  // namespace softwet
