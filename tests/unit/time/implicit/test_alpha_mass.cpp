// The mass that steps carry along: first moments, and uniform states on a mesh that moves.
#include "unit/time/implicit/random_steps.hpp"

namespace softwet::testing_tools {
namespace {

TEST(GeneralizedAlpha, InitialMomentsAreTheMass) {
  RandomState s(small_case(SceneKind::coupled));
  s.integrator.initialise(s.state);
  double mass = 0, rate = 0, size = 0;
  for (double p : to_host(s.state.moment)) mass += p;
  for (double p : to_host(s.state.moment_rate)) {
    rate += p;
    size += std::abs(p);
  }
  EXPECT_NEAR(mass, s.random.scene.balance().measure(stage_at(s.random.layout(), s.state)).integrals["mass"], 1e-15);
  EXPECT_GT(size, 1e-4);
  EXPECT_NEAR(rate, 0, 1e-14 * size);
}

/// Uniform fluid, driven through given wall velocities; calls check(state before, x) at every step.
template <class Velocity, class Check>
void drive(RandomState& s, int steps, double end, const Velocity& velocity, const Check& check) {
  const Layout<2>& l = s.random.layout();
  std::vector<double> y(l.size(), 0.0);
  for (int i = 0; i < l.scalar_size(); ++i) {
    y[l.density_offset() + i] = 0.5;
    y[l.potential_offset() + i] = s.random.scene.coefficients().fluid().gas.derivative(0.5);
  }
  Kokkos::deep_copy(s.state.unknown, to_device<Array>(y));
  Kokkos::deep_copy(s.state.velocity_rate, 0.0);
  Kokkos::deep_copy(s.state.displacement_rate, 0.0);
  s.state.time = 0;
  s.integrator.initialise(s.state);
  for (int n = 0; n < steps; ++n) {
    const double dt = end / steps;
    const std::vector<double> old = to_host(s.state.unknown);
    std::vector<double> x = old;
    for (int i = 0; i < l.velocity_size(); ++i) x[i] += 2.0 / 3 * (velocity(i, (n + 1) * dt) - x[i]);
    s.integrator.begin(s.state, dt);
    const Array middle = to_device<Array>(x);
    check(middle);
    s.integrator.finish(middle, s.state);
    std::vector<double> after = to_host(s.state.unknown);  // uniform again: only the moments show a loss
    std::copy(y.begin() + l.density_offset(), y.end(), after.begin() + l.density_offset());
    Kokkos::deep_copy(s.state.unknown, to_device<Array>(after));
  }
}

/// Largest relative deviation of the moments from the moments of the uniform state on the mesh of the end, away from
/// the wall's layer, where the prescribed velocity compresses the fluid.
double deviation(int steps) {
  RandomState s(small_case(SceneKind::coupled));
  const Layout<2>& l = s.random.layout();
  Kokkos::deep_copy(s.state.displacement, 0.0);
  const std::vector<double> shape = to_host(s.random.stage().unknown);
  const auto velocity = [&](int i, double t) {
    const int row = i / l.row_size % l.rows;
    const double a = std::sin(M_PI * t);
    return row == l.wall_row ? 0.1 * shape[i] * a * a : 0.0;
  };
  RandomState uniform(small_case(SceneKind::coupled));
  drive(s, steps, 0.8, velocity, [](const Array&) {});
  State fresh = s.state;
  fresh.moment = Array("moment", l.scalar_size());
  fresh.moment_rate = Array("rate", l.scalar_size());
  uniform.integrator.initialise(fresh);
  const std::vector<double> p = to_host(s.state.moment), expected = to_host(fresh.moment);
  double worst = 0;
  for (int i = 3 * l.row_size; i < l.scalar_size(); ++i) worst = std::max(worst, std::abs(p[i] / expected[i] - 1));
  return worst;
}

TEST(GeneralizedAlpha, UniformDensityOnAMovingMeshIsKeptToSecondOrder) {
  const double a = deviation(20), b = deviation(40), c = deviation(80);
  std::printf("  deviation from uniform, 20, 40, 80 steps: %.2e %.2e %.2e\n", a, b, c);
  EXPECT_GT(a, 1e-9);
  EXPECT_NEAR(std::log2(a / b), 2, 0.25);
  EXPECT_NEAR(std::log2(b / c), 2, 0.15);
}

// All of it in translation above a wall that is not flat: J depends linearly on time's displacement, and the scheme
// keeps the uniform density exactly, however the velocity varies.
TEST(GeneralizedAlpha, UniformDensityInTranslationIsKeptExactly) {
  RandomState s(small_case(SceneKind::coupled, WallLaw::gradient, true));
  const Layout<2>& l = s.random.layout();
  const auto velocity = [&](int i, double t) { return i < l.velocity_offset(1) ? 0.3 * t + std::sin(3 * t) : 0.0; };
  double worst = 0;
  const Array r("r", l.size());
  drive(s, 12, 0.6, velocity, [&](const Array& x) {
    s.integrator.residual(x, r);
    const std::vector<double> v = to_host(r);
    for (int i = l.density_offset(); i < l.potential_offset(); ++i)
      worst = std::max(worst, std::abs(v[i]) / s.integrator.stage().moment_rate);
  });
  EXPECT_LT(worst, 1e-16) << "of moments around 5e-3";
}

}  // namespace
}  // namespace softwet::testing_tools
