// Whole steps: second order of the scheme, conservation of mass, restart.
#include "time/stepper.hpp"

#include "scene/initial.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// A scene that starts in equilibrium and is set in motion by the ramp of its load, with steps of one size.
Case driven(SceneKind kind, double dt) {
  Case c = small_case(kind);
  c.loads[0].start = 0;
  c.loads[0].ramp = 10;
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = dt;
  c.time.tolerance = 1e30;
  c.solver.newton_rtol = 1e-9;
  c.solver.newton_atol = 1e-12;
  c.solver.krylov_rtol = 1e-4;
  c.solver.newton_max = 30;
  c.domain.elements = {4, 3};  // coarse: the steps resolve the highest mode
  if (c.fluid) {
    c.fluid->temperature = 0.8;
    c.fluid->contact_angle = 90;
  }
  return c;
}

constexpr double end = 0.4;

/// Velocities and displacements at the end after `steps` steps. A fluid starts at the liquid density without pressure.
std::vector<double> run(SceneKind kind, int steps) {
  const Case c = driven(kind, end / steps);
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  Stepper<2, 2> stepper(scene, c, {});
  State state = empty_state(l);
  if (l.has_fluid) {
    const double rho = 0.5 + std::sqrt(0.25 - 8.0 / 27 * 0.8);
    std::vector<double> x(l.size(), 0.0);
    for (int i = 0; i < l.scalar_size(); ++i) {
      x[l.density_offset() + i] = rho;
      x[l.potential_offset() + i] = scene.coefficients().fluid().gas.derivative(rho);
    }
    state.unknown = to_device<Array>(x);
  }
  stepper.scheme().initialise(state);
  stepper.start(state);
  for (int n = 0; n < steps; ++n) stepper.step();
  EXPECT_NEAR(stepper.state().time, end, 1e-12);
  EXPECT_EQ(stepper.counts().rejected_newton, 0) << stepper.counts().last_rejection.text();
  std::vector<double> result = to_host(stepper.state().unknown), u = to_host(stepper.state().displacement);
  result.resize(l.has_fluid ? l.potential_offset() : l.size());  // mu is collocated inside the step
  result.insert(result.end(), u.begin(), u.end());
  return result;
}

void expect_second_order(SceneKind kind) {
  const std::vector<double> reference = run(kind, 384);
  const double a = distance(run(kind, 24), reference), b = distance(run(kind, 48), reference);
  std::printf("  errors with 24 and 48 steps: %.2e %.2e\n", a, b);
  EXPECT_NEAR(std::log2(a / b), 2, 0.2);
}
TEST(Stepper, SecondOrderForAVibratingSolid) { expect_second_order(SceneKind::solid); }
TEST(Stepper, SecondOrderForFluidOnSolid) { expect_second_order(SceneKind::coupled); }

Case droplet(SceneKind kind) {
  Case c = small_case(kind, WallLaw::energy);
  c.domain.elements = {18, 12};
  c.fluid->capillarity = 0.1;
  c.fluid->stabilisation = 0.002;
  c.boundary.side[0] = {Side::slip, Side::slip};
  c.droplets = {{{0.45, kind == SceneKind::coupled ? 0.8 / 3 : 0.0}, 0.3}};
  return c;
}

/// Masses and moments over a few steps at default tolerances.
void check_mass(SceneKind kind, double drift) {
  const Case c = droplet(kind);
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  State state = initial_state(c, scene);
  stepper.scheme().initialise(state);
  stepper.start(state);
  const auto mass = [&] {
    return scene.balance().measure(stage_at(scene.layout(), stepper.state())).integrals["mass"];
  };
  const auto moments = [&] {
    double sum = 0;
    for (double p : to_host(stepper.state().moment)) sum += p;
    return sum;
  };
  const double mass_before = mass(), moments_before = moments();
  for (int n = 0; n < 15; ++n) stepper.step();
  std::printf("  mass drift %.1e, sum of moments %.1e\n", mass() / mass_before - 1, moments() / moments_before - 1);
  EXPECT_NEAR(moments() / moments_before, 1, 3e-15);
  EXPECT_NEAR(mass() / mass_before, 1, drift);
}
TEST(Stepper, MassOnAFixedMesh) { check_mass(SceneKind::rigid, 1e-13); }
TEST(Stepper, MassOnAMovingMesh) { check_mass(SceneKind::coupled, 1e-12); }

TEST(Stepper, RestoredRunTakesTheSameSteps) {
  const Case c = droplet(SceneKind::rigid);
  const Scene<2, 2> scene(c);
  Stepper<2, 2> first(scene, c, {});
  State state = initial_state(c, scene);
  first.scheme().initialise(state);
  first.start(state);
  for (int n = 0; n < 3; ++n) first.step();
  Stepper<2, 2> second(scene, c, {});
  second.restore(first.state(), first.previous(), first.previous_dt(), first.control().proposed());
  first.scheme().refuse({Refusal::newton});  // a restart factorises anew
  for (int n = 0; n < 2; ++n) {
    first.step();
    second.step();
  }
  EXPECT_EQ(to_host(first.state().unknown), to_host(second.state().unknown));
  EXPECT_EQ(to_host(first.state().moment_rate), to_host(second.state().moment_rate));
  EXPECT_EQ(first.state().time, second.state().time);
}

// The largest step that converges is refused again and again: the error names the reason, the state is the last good.
TEST(Stepper, GivesUpWithTheLastGoodState) {
  Case c = droplet(SceneKind::rigid);
  c.solver.newton_max = 0;
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  State state = initial_state(c, scene);
  stepper.scheme().initialise(state);
  stepper.start(state);
  EXPECT_THROW(stepper.step(), std::exception);
  EXPECT_EQ(to_host(stepper.state().unknown), to_host(state.unknown));
  EXPECT_EQ(stepper.state().time, 0);
  EXPECT_EQ(stepper.counts().steps, 0);
  EXPECT_GT(stepper.counts().rejected_newton, 10);
}

/// A step of 1e-5 from a droplet with one control value of the vapour at -0.02. @return reason of a rejection, or empty
std::string step_from_undershoot(double allowed) {
  Case c = droplet(SceneKind::rigid);
  c.solver.newton_undershoot = allowed;
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = 1e-5;
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  State state = initial_state(c, scene);
  std::vector<double> x = to_host(state.unknown);
  x[scene.layout().potential_offset() - 1] = -0.02;  // the corner farthest from the droplet
  state.unknown = to_device<Array>(x);
  stepper.scheme().initialise(state);
  stepper.start(state);
  try {
    stepper.step();
  } catch (const std::exception&) {
  }
  return stepper.counts().last_rejection.text();
}
TEST(Stepper, UndershootOfTheDensityIsAllowedAsFarAsTheCaseSays) {
  EXPECT_EQ(step_from_undershoot(0.03), "");
  EXPECT_NE(step_from_undershoot(0.01).find("solver.newton.undershoot"), std::string::npos);
}

}  // namespace
}  // namespace softwet::testing_tools
