// The displacements of branches in steps of generalized-alpha: exact where the solution is known, of second order, at
// rest.
#include "time/step/branch_memory.hpp"

#include <gtest/gtest.h>

#include "time/implicit/generalized_alpha.hpp"

namespace softwet::branch_memory {
namespace {

constexpr double frequency = 2, time_of[2] = {0.37, 1e-4};

Branches two_branches() {
  Branches b;
  b.count = 2;
  for (int i = 0; i < 2; ++i) {
    b.modulus[i] = 0.4 + i;
    b.time[i] = time_of[i];
  }
  return b;
}

/// a of tau a' = sin(w t) - a, a(0) = 0.
double exact(double tau, double t) {
  const double w = frequency, turn = w * tau;
  return (std::sin(w * t) - turn * std::cos(w * t) + turn * std::exp(-t / tau)) / (1 + turn * turn);
}
double exact_rate(double tau, double t) { return (std::sin(frequency * t) - exact(tau, t)) / tau; }

AlphaStep step_of(const AlphaParameters& a, double dt) {
  return {a.af, dt * (1 - a.ga / a.am), dt * a.ga / a.am, 1 - 1 / a.am, 1 / a.am};
}

struct Errors {
  double memory[2], rate[2];
};

/// Errors for one displacement that swings, at t = 2.
Errors errors(double rho_inf, int steps) {
  const double dt = 2.0 / steps;
  BranchMemory memory(two_branches(), 1);
  State state;
  state.memory = Array("memory", 2);
  state.memory_rate = Array("rate", 2);
  for (int n = 0; n < steps; ++n) {
    const AlphaParameters a = n == 0 ? AlphaParameters::backward_euler() : AlphaParameters(rho_inf);  // as runs begin
    memory.begin(state, step_of(a, dt), {});
    memory.finish(state, to_device<Array>(std::vector<double>{std::sin(frequency * (n + a.af) * dt)}), state);
  }
  const std::vector<double> found = to_host(state.memory), rate = to_host(state.memory_rate);
  Errors e{};
  for (int i = 0; i < 2; ++i) {
    e.memory[i] = std::abs(found[i] - exact(time_of[i], 2));
    const AlphaParameters a(rho_inf);
    const double moving = two_branches().share_of_velocity(i, (a.am - a.af) * dt);
    const double velocity = frequency * std::cos(frequency * 2);
    e.rate[i] = std::abs((1 - moving) * rate[i] + moving * velocity - exact_rate(time_of[i], 2));
  }
  return e;
}

// The second branch is 100 times faster than a step and more: it follows the displacement. With rho_inf = 1 the error
// of its first step swings on undamped, as with any trapezoidal rule, and stays small.
TEST(BranchMemory, IsOfSecondOrderForAnyStep) {
  for (const double rho_inf : {0.0, 0.5, 1.0}) {
    const Errors a = errors(rho_inf, 80), b = errors(rho_inf, 160);
    for (int i = 0; i < 2; ++i) {
      std::printf("  rho_inf %.1f, time %g: errors %.1e %.1e, of the rate %.1e %.1e\n", rho_inf, time_of[i],
                  a.memory[i], b.memory[i], a.rate[i], b.rate[i]);
      EXPECT_LT(b.memory[i], 2e-4);
    }
    EXPECT_NEAR(std::log2(a.memory[0] / b.memory[0]), 2, 0.15) << rho_inf;
    EXPECT_NEAR(std::log2(a.rate[0] / b.rate[0]), 2, 0.15) << rho_inf;
    EXPECT_GT(std::log2(a.memory[1] / b.memory[1]), 1.8) << rho_inf;
    EXPECT_LT(b.rate[1], rho_inf < 1 ? 1e-4 : 0.05);
  }
}

TEST(BranchMemory, LagIsWhatIsLeftOfTheEquation) {
  const Branches branches = two_branches();
  const AlphaStep step = step_of(AlphaParameters(0.5), 0.1);
  BranchMemory memory(branches, 3);
  State state;
  state.memory = to_device<Array>(std::vector<double>{0.1, 0.2, -0.3, 0.4, 0.5, 0.6});
  state.memory_rate = to_device<Array>(std::vector<double>{1, -2, 3, 0.3, 0.2, 0.1});
  const std::vector<double> a0 = to_host(state.memory), u{0.7, -0.2, 0.9};
  const Array lag("lag", 3);
  memory.begin(state, step, {});
  memory.set_lag(to_device<Array>(u), lag);
  State end;
  end.memory = Array("memory", 6);
  end.memory_rate = Array("rate", 6);
  memory.finish(state, to_device<Array>(u), end);
  const std::vector<double> a1 = to_host(end.memory), found = to_host(lag);
  for (int i = 0; i < 3; ++i) {
    double expected = 0;
    for (int b = 0; b < 2; ++b) {
      const double middle = a0[3 * b + i] + step.af * (a1[3 * b + i] - a0[3 * b + i]);
      expected += 2 * branches.modulus[b] * (u[i] - middle);
    }
    EXPECT_NEAR(found[i], expected, 1e-13) << "sum of 2 G (u - a) in the middle of the step";
  }
}

FollowFactors factors_of(const BranchMemory& memory, double dt) {
  std::vector<double> numbers(2 * memory.count());
  memory.find_factors(dt, numbers.data());
  FollowFactors factors{};
  for (int b = 0; b < memory.count(); ++b) {
    factors.faded[b] = numbers[2 * b];
    factors.followed[b] = numbers[2 * b + 1];
  }
  return factors;
}

// A displacement that moves at one speed is followed exactly, by slow branches and by fast ones.
TEST(BranchMemory, FollowsASteadyMotionExactly) {
  const double dt = 0.2, speed = 0.7;
  BranchMemory memory(two_branches(), 1);
  const Array out("out", 2), rate("rate", 2), lag("lag", 1);
  const Array before = to_device<Array>(std::vector<double>{0.1}),
              after = to_device<Array>(std::vector<double>{0.1 + speed * dt});
  memory.follow(factors_of(memory, dt), before, after, to_device<Array>(std::vector<double>{0.4, -0.2}), out);
  memory.set_rate(after, out, rate);
  memory.set_lag(after, out, lag);
  const std::vector<double> found = to_host(out), rates = to_host(rate), start{0.4, -0.2};
  double expected_lag = 0;
  for (int i = 0; i < 2; ++i) {
    const double tau = time_of[i];
    const double expected = 0.1 + speed * (dt - tau) + (start[i] - 0.1 + speed * tau) * std::exp(-dt / tau);
    EXPECT_NEAR(found[i], expected, 1e-15);
    EXPECT_NEAR(rates[i], (0.1 + speed * dt - expected) / tau, 1e-11);
    expected_lag += 2 * two_branches().modulus[i] * (0.1 + speed * dt - expected);
  }
  EXPECT_NEAR(to_host(lag)[0], expected_lag, 1e-14);
}

// Under finite strains branches follow a function of the displacement, here its square, at other places than control
// values.
TEST(BranchMemory, FollowsAStrain) {
  const StrainFollowed square = [](const ConstArray& u, const Array& out) {
    std::vector<double> x = to_host(u);
    x.push_back(0.5);
    for (double& value : x) value *= value;
    Kokkos::deep_copy(out, to_device<Array>(x));
  };
  const Branches branches = two_branches();
  const AlphaStep step = step_of(AlphaParameters(0.5), 0.1);
  BranchMemory memory(branches, 3, square);
  State state, end;
  state.memory = to_device<Array>(std::vector<double>{0.1, 0.2, -0.3, 0.4, 0.5, 0.6});
  state.memory_rate = to_device<Array>(std::vector<double>{1, -2, 3, 0.3, 0.2, 0.1});
  end.memory = Array("memory", 6);
  end.memory_rate = Array("rate", 6);
  const std::vector<double> a0 = to_host(state.memory), x{0.49, 0.04, 0.25};
  const Array u = to_device<Array>(std::vector<double>{0.7, -0.2}), lag("lag", 3), later("lag", 3);
  memory.begin(state, step, lag);
  memory.set_lag(u, lag);  // does nothing: h belongs to the step
  memory.finish(state, u, end);
  const std::vector<double> a1 = to_host(end.memory), h = to_host(lag);
  const double weight = memory.weight(step.af * step.taken);
  for (int i = 0; i < 3; ++i) {
    double expected = 0;
    for (int b = 0; b < 2; ++b)
      expected += 2 * branches.modulus[b] * (x[i] - a0[3 * b + i] - step.af * (a1[3 * b + i] - a0[3 * b + i]));
    EXPECT_NEAR(weight * (x[i] - h[i]), expected, 1e-13) << "sum of 2 G (x - a) in the middle of the step";
  }
  memory.set_lag(u, end.memory, later);
  const double moduli = 2 * (branches.modulus[0] + branches.modulus[1]);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(to_host(later)[i], 2 * (branches.modulus[0] * a1[i] + branches.modulus[1] * a1[3 + i]) / moduli, 1e-15);
  state.displacement = u;
  memory.rest(state);
  const std::vector<double> rested = to_host(state.memory);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(rested[i], x[i % 3], 1e-15);
}

TEST(BranchMemory, AtRestFollowsTheDisplacement) {
  BranchMemory memory(two_branches(), 2);
  State state;
  state.displacement = to_device<Array>(std::vector<double>{0.3, 0.4});
  state.memory = Array("memory", 4);
  state.memory_rate = to_device<Array>(std::vector<double>{1, 1, 1, 1});
  memory.rest(state);
  EXPECT_EQ(to_host(state.memory), (std::vector<double>{0.3, 0.4, 0.3, 0.4}));
  EXPECT_EQ(to_host(state.memory_rate), (std::vector<double>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace softwet::branch_memory
