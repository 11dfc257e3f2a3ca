// Growth rates of disturbances at rest: waves in a viscous layer, and motions that are computed step by step.
#include "time/rest/growth.hpp"

#include <cmath>

#include "scene/initial.hpp"
#include "time/rest/relaxation.hpp"
#include "time/stepper.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

// A layer that is held below and free above, and viscous: rho r^2 + (eta r + mu) k^2 = 0 with k = pi / (2 H).
TEST(Growth, ShearWavesOfAViscousLayerHaveTheirExactRates) {
  Case c = small_case(SceneKind::solid, WallLaw::gradient, true);
  c.loads.clear();
  c.boundary.side[1][0] = Side::no_slip;
  c.substrate->young = 0.02;
  c.substrate->viscosity = 0.02;
  const Scene<2, 2> scene(c);
  State rest = initial_state<2, 2>(c, scene);
  const Growth growth = growth_at_rest<2, 2>(scene, c, rest);
  ASSERT_EQ(growth.why, "");
  const double k = M_PI / 2 / 0.8, mu = scene.coefficients().solid().stiffness.shear_modulus, rho = 1.3;
  const double damping = 0.02 * k * k / (2 * rho), frequency = std::sqrt(mu * k * k / rho - damping * damping);
  EXPECT_NEAR(growth.rates[0].real(), -damping, 0.01 * damping);
  EXPECT_NEAR(std::abs(growth.rates[0].imag()), frequency, 0.01 * frequency);
}

// An elastic layer swings for ever: neither stable nor unstable, though its waves are fast.
TEST(Growth, WavesOfAnElasticLayerStay) {
  Case c = small_case(SceneKind::solid, WallLaw::gradient, true);
  c.loads.clear();
  c.boundary.side[1][0] = Side::no_slip;
  const Scene<2, 2> scene(c);
  const State rest = initial_state<2, 2>(c, scene);
  const Growth growth = growth_at_rest<2, 2>(scene, c, rest);
  ASSERT_EQ(growth.why, "");
  const double k = M_PI / 2 / 0.8,
               frequency = k * std::sqrt(scene.coefficients().solid().stiffness.shear_modulus / 1.3);
  std::printf("  %g + %g i after %d steps\n", growth.rates[0].real(), growth.rates[0].imag(), growth.steps);
  EXPECT_LT(std::abs(growth.rates[0].real()), neutral_rate);
  EXPECT_NEAR(std::abs(growth.rates[0].imag()), frequency, 0.01 * frequency);
}

/// A coarse scene with a droplet, at rest.
struct Resting {
  Case c;
  Scene<2, 2> scene;
  State state;

  explicit Resting(SceneKind kind) : c(with_droplet(kind)), scene(c), state(initial_state<2, 2>(c, scene)) {
    EXPECT_EQ((relax<2, 2>(scene, c, state).why), "");
  }
  static Case with_droplet(SceneKind kind) {
    Case c = small_case(kind, WallLaw::energy);
    c.loads.clear();
    c.fluid->smoothing = 1e-4;
    c.fluid->viscosity = 0.02;
    c.fluid->capillarity = 0.1;
    c.droplets = {{{0.45, kind == SceneKind::rigid ? 0.0 : 0.8 / 3}, 0.3}};
    return c;
  }
};

/// The rate from the density's disturbance after `steps` steps of dt and after twice as many.
double rate_of_run(const Resting& rest, double dt, int steps) {
  Case c = rest.c;
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = dt;
  c.time.tolerance = 1e30;
  c.solver.newton_rtol = 1e-9;
  // Above round-off, of which the algorithms of a device have four times as much.
  c.solver.newton_atol = host_algorithms ? 1e-14 : 1e-13;
  c.waves = {{WaveField::density, 1e-6, {1, 0}}};
  const Layout<2>& l = rest.scene.layout();
  State with_wave = initial_state<2, 2>(c, rest.scene);
  c.waves.clear();
  const State without = initial_state<2, 2>(c, rest.scene);
  State state = rest.state;
  state.unknown = Array("disturbed", l.size());
  combine(state.unknown, 1, rest.state.unknown, 0);
  add_scaled(state.unknown, 0, 1, with_wave.unknown);
  add_scaled(state.unknown, 0, -1, without.unknown);
  Stepper<2, 2> stepper(rest.scene, c, {});
  stepper.scheme().initialise(state);
  stepper.start(state);
  const auto distance_after = [&] {
    for (int n = 0; n < steps; ++n) stepper.step();
    Array away("away", l.scalar_size());
    combine(away, 1, part(stepper.state().unknown, l.density_offset(), l.potential_offset()), 0);
    add_scaled(away, 0, -1, part(rest.state.unknown, l.density_offset(), l.potential_offset()));
    return norm(alone, away);
  };
  const double first = distance_after();
  return std::log(distance_after() / first) / (steps * dt);
}

// A droplet that is the image of itself in a mirror lies on a coarse mesh where it should not: it rests, but a
// disturbance grows as its mode says.
TEST(Growth, DisturbancesGrowInARunAsTheirModeDoes) {
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled}) {
    const Resting rest(kind);
    const Growth growth = growth_at_rest<2, 2>(rest.scene, rest.c, rest.state);
    ASSERT_EQ(growth.why, "");
    const double rate = growth.rates[0].real();
    const double found = rate_of_run(rest, 0.1 / rate, 25);
    std::printf("  %g, in a run %g; %d steps, %ld iterations\n", rate, found, growth.steps, growth.krylov);
    EXPECT_GT(rate, 1e-3);
    EXPECT_NEAR(found, rate, 0.02 * rate);
  }
}

// A run that is stopped has no rates, and says so.
TEST(Growth, EndsWhereItIsAskedTo) {
  const Resting rest(SceneKind::rigid);
  const Growth growth = growth_at_rest<2, 2>(rest.scene, rest.c, rest.state, [] { return true; });
  EXPECT_TRUE(growth.rates.empty());
  EXPECT_EQ(growth.why, "the search was stopped");
}

}  // namespace
}  // namespace softwet::testing_tools
