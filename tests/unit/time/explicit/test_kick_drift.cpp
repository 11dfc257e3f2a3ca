// The scheme kick_drift: its order, what it keeps, and that its steps leave no trace before they are accepted.
#include "time/explicit/kick_drift.hpp"

#include "unit/time/explicit_run.hpp"

namespace softwet::testing_tools {
namespace {

/// Differences to a run of ssp_rk3 with many steps, of all unknowns at one time.
double error_of(const Case& c, TimeScheme scheme, int steps, const Array& exact) {
  ExplicitRun run(c, scheme);
  run.run(0.2 / steps, steps);
  return root_of_squares(run.state.unknown, exact, 0, static_cast<int>(exact.extent(0)));
}

/// @param most  the order may seem higher where terms of higher order are larger
void expect_second_order(const Case& c, TimeScheme scheme, double most = 2.35) {
  ExplicitRun exact(c, TimeScheme::ssp_rk3);
  exact.run(0.2 / 320, 320);
  const double a = error_of(c, scheme, 40, exact.state.unknown), b = error_of(c, scheme, 80, exact.state.unknown);
  std::printf("  %s: errors %.2e, %.2e, order %.2f\n", word_of(scheme).c_str(), a, b, std::log2(a / b));
  EXPECT_GT(std::log2(a / b), 1.65);
  EXPECT_LT(std::log2(a / b), most);
}

TEST(KickDrift, IsOfSecondOrderWithASoftLayerAndALoad) {
  expect_second_order(moving_droplet(SceneKind::coupled), TimeScheme::kick_drift);
}
TEST(KickDrift, IsOfSecondOrderAroundAnAxisOfSymmetry) {
  expect_second_order(around_axis(moving_droplet(SceneKind::coupled)), TimeScheme::kick_drift);
}
TEST(KickDrift, IsOfSecondOrderInASolid) {
  expect_second_order(moving_droplet(SceneKind::solid), TimeScheme::kick_drift);
}
TEST(KickDrift, SspRk3WithViscosityApartIsOfSecondOrderOrMore) {
  expect_second_order(moving_droplet(SceneKind::rigid), TimeScheme::rkl2, 3.2);
}

/// Differences between rkl2 and fine steps of ssp_rk3 after a while, of velocities and displacements, over the size of
/// these.
std::pair<double, double> errors_of_rkl2(const Case& c, MassKind kind, double dt, int steps) {
  ExplicitRun exact(c, TimeScheme::ssp_rk3, kind), run(c, TimeScheme::rkl2, kind);
  const int fine = 1 + static_cast<int>(dt * steps * exact.rates().combined / 0.5);
  exact.run(dt * steps / fine, fine);
  run.run(dt, steps);
  const int nv = run.system.velocities(), nu = run.system.displacements();
  const Array zero("zero", nv);
  return {root_of_squares(run.state.unknown, exact.state.unknown, 0, nv) /
              root_of_squares(zero, exact.state.unknown, 0, nv),
          root_of_squares(run.state.displacement, exact.state.displacement, 0, nu) /
              root_of_squares(zero, exact.state.displacement, 0, nu)};
}

// The viscous rate is a hundred times 1/dt, so that the solid creeps: its speed is where viscosity balances the load.
// Without this balance it would be fifty times as fast. The error in sixteen steps from rest, under a load that begins
// to grow, falls with the square of the steps.
TEST(KickDrift, ViscosityApartFindsTheSpeedOfCreep) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped})
    for (Case c : {moving_droplet(SceneKind::solid), around_axis(moving_droplet(SceneKind::solid)),
                   moving_droplet(SceneKind::coupled)}) {
      c.substrate->viscosity = 3;
      c.substrate->bulk_viscosity = 1;
      ExplicitRun first(c, TimeScheme::rkl2, kind);
      const double dt = 0.8 / first.rates().combined;
      const auto [v, u] = errors_of_rkl2(c, kind, dt, 16);
      const auto [half_v, half_u] = errors_of_rkl2(c, kind, dt / 2, 32);
      std::printf("  masses %d: dt s %.1f, errors %.2e, %.2e, orders %.2f, %.2f\n", int(kind),
                  dt * first.rates().viscosity, v, u, std::log2(v / half_v), std::log2(u / half_u));
      EXPECT_GT(dt * first.rates().viscosity, 100);
      EXPECT_LT(half_u, 0.05);
      EXPECT_GT(std::log2(u / half_u), 1.5);
    }
}

TEST(KickDrift, KeepsTheMomentsOnAMovingMesh) {
  for (const Case& c : {moving_droplet(SceneKind::coupled, false), moving_droplet(SceneKind::coupled, true),
                        around_axis(moving_droplet(SceneKind::coupled))}) {
    ExplicitRun run(c, TimeScheme::kick_drift);
    const double before = total(alone, run.state.moment);
    run.run(0.9 / run.rates().combined, 50);
    EXPECT_NEAR(total(alone, run.state.moment), before, 1e-14 * before);
  }
}

TEST(KickDrift, TheEnergyFallsAtItsBound) {
  for (const Case& c : {moving_droplet(SceneKind::rigid), around_axis(moving_droplet(SceneKind::rigid))}) {
    ExplicitRun run(c, TimeScheme::kick_drift);
    double before = run.scene.balance().measure(stage_at(run.scene.layout(), run.state)).integrals.energy();
    for (int n = 0; n < 60; ++n) {
      run.run(0.9 / run.rates().combined, 1);
      const double now = run.scene.balance().measure(stage_at(run.scene.layout(), run.state)).integrals.energy();
      ASSERT_LT(now, before) << n;
      before = now;
    }
  }
}

TEST(KickDrift, AStepThatIsNotAcceptedLeavesNoTrace) {
  for (const TimeScheme scheme : {TimeScheme::kick_drift, TimeScheme::rkl2, TimeScheme::ssp_rk3}) {
    const Case c = moving_droplet(SceneKind::coupled);
    ExplicitRun once(c, scheme), twice(c, scheme);
    const double dt = 0.5 / once.rates().combined;
    once.run(dt, 3);
    twice.run(dt, 2);
    const StepRates rates = twice.rates();
    for (const double length : {1.7 * dt, dt})
      ASSERT_TRUE(twice.step->advance(twice.state.time, length, rates).empty());
    twice.step->accept(twice.state.time + dt, dt, twice.state, twice.before);
    EXPECT_EQ(to_host(once.state.unknown), to_host(twice.state.unknown)) << word_of(scheme);
    EXPECT_EQ(to_host(once.state.displacement), to_host(twice.state.displacement)) << word_of(scheme);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
