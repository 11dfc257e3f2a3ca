// A run that is put together anew before each step gives the bits of one that goes on.
#include "scene/initial.hpp"
#include "time/stepper.hpp"
#include "unit/field/kept_memory.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using Steps = Stepper<2, 2>;

/// A droplet that begins to move.
Case restless_droplet(SceneKind kind, bool periodic = false) {
  Case c = small_case(kind, WallLaw::energy, periodic);
  c.domain.elements = {18, 12};
  for (Load& load : c.loads) load.start = 0;
  if (c.fluid) {
    c.fluid->capillarity = 0.1;
    c.fluid->stabilisation = 0.002;
    c.droplets = {{{0.45, kind == SceneKind::coupled ? 0.8 / 3 : 0.0}, 0.3}};
  }
  return c;
}

std::unique_ptr<Steps> stepper_at_start(const Case& c, const Scene<2, 2>& scene) {
  auto stepper = std::make_unique<Steps>(scene, c, std::vector<double>{});
  State state = initial_state(c, scene);
  stepper->scheme().initialise(state);
  stepper->start(state);
  return stepper;
}

/// A new stepper from what a checkpoint holds of another one.
std::unique_ptr<Steps> resumed(const Case& c, const Scene<2, 2>& scene, Steps& from) {
  KeptMemory memory;
  from.scheme().visit_memory(memory, from.state());
  auto stepper = std::make_unique<Steps>(scene, c, std::vector<double>{});
  stepper->restore(from.state(), from.previous(), from.previous_dt(), from.control().proposed());
  memory.put_back();
  stepper->scheme().visit_memory(memory, stepper->state());
  return stepper;
}

/// All numbers of a step and of the state behind it.
std::vector<double> step_of(Steps& stepper) {
  const StepReport r = stepper.step();
  const State& s = stepper.state();
  std::vector<double> all{r.dt, double(r.newton), double(r.krylov), r.indicator, s.time};
  for (const Array& a : {s.unknown, s.velocity_rate, s.displacement, s.displacement_rate, s.moment, s.moment_rate,
                         s.memory, s.memory_rate}) {
    const std::vector<double> values = to_host(a);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

/// @return builds of preconditioners in the run that goes on
long expect_same_bits(const Case& c, int steps) {
  const Scene<2, 2> scene(c);
  const auto whole = stepper_at_start(c, scene);
  auto parts = stepper_at_start(c, scene);
  for (int n = 0; n < steps; ++n) {
    parts = resumed(c, scene, *parts);
    EXPECT_EQ(step_of(*whole), step_of(*parts)) << "step " << n;
    if (testing::Test::HasFailure()) break;
  }
  return whole->scheme().counts().builds;
}

TEST(StepMemory, ImplicitRunsGoOnWithTheirPreconditioner) {
  constexpr int steps = 12;
  for (const PreconditionerKind preconditioner : {PreconditionerKind::lu, PreconditionerKind::schwarz})
    for (const PrecisionChoice precision : {PrecisionChoice::full, PrecisionChoice::mixed}) {
      SCOPED_TRACE(word_of(preconditioner) + ", " + word_of(precision));
      Case c = restless_droplet(SceneKind::coupled);
      c.solver.preconditioner = preconditioner;
      c.solver.precision = precision;
      EXPECT_LT(expect_same_bits(c, steps), steps) << "no preconditioner was kept";
    }
}

TEST(StepMemory, ImplicitRunsGoOnInAllScenes) {
  for (const Case& c : {restless_droplet(SceneKind::rigid), restless_droplet(SceneKind::solid),
                        restless_droplet(SceneKind::rigid, true), restless_droplet(SceneKind::coupled, true)})
    expect_same_bits(c, 8);
}

TEST(StepMemory, ImplicitRunsGoOnWithTheirBranches) {
  for (const PrecisionChoice precision : {PrecisionChoice::full, PrecisionChoice::mixed})
    for (const SceneKind kind : {SceneKind::coupled, SceneKind::solid}) {
      SCOPED_TRACE(word_of(precision));
      Case c = restless_droplet(kind);
      c.substrate->strain = Strain::small;
      c.substrate->branches = {{0.9, 0.3}, {1.7, 0.004}};
      c.solver.precision = precision;
      expect_same_bits(c, 8);
    }
}

TEST(StepMemory, WhatIsForgottenIsBuiltAnew) {
  const Case c = restless_droplet(SceneKind::coupled);
  const Scene<2, 2> scene(c);
  const auto whole = stepper_at_start(c, scene), parts = stepper_at_start(c, scene);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(step_of(*whole), step_of(*parts));
  whole->scheme().refuse({Refusal::newton});
  parts->scheme().refuse({Refusal::newton});
  const auto after = resumed(c, scene, *parts);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(step_of(*whole), step_of(*after)) << n;
}

/// Steps follow the bound from the state, so that any change of it shows.
void expect_same_explicit_bits(TimeScheme scheme, SceneKind kind, bool periodic) {
  for (const MassKind mass : {MassKind::lumped, MassKind::corrected, MassKind::consistent}) {
    SCOPED_TRACE(word_of(scheme) + ", " + word_of(mass));
    Case c = restless_droplet(kind, periodic);
    c.domain.elements = {6, 6};
    c.time.scheme = scheme;
    c.time.mass = mass;
    c.time.tolerance = 1e30;
    c.time.dt_initial = 1;
    expect_same_bits(c, 8);
  }
}

TEST(StepMemory, SspRk3GoesOnWithItsBound) {
  expect_same_explicit_bits(TimeScheme::ssp_rk3, SceneKind::coupled, false);
}
TEST(StepMemory, Rkl2GoesOnWithItsStages) { expect_same_explicit_bits(TimeScheme::rkl2, SceneKind::coupled, false); }
TEST(StepMemory, KickDriftGoesOnWithItsAccelerations) {
  expect_same_explicit_bits(TimeScheme::kick_drift, SceneKind::coupled, false);
}
TEST(StepMemory, ExplicitRunsGoOnAroundAPeriodicAxis) {
  expect_same_explicit_bits(TimeScheme::kick_drift, SceneKind::rigid, true);
}
TEST(StepMemory, ExplicitRunsGoOnWithTheirBranches) {
  for (const SceneKind kind : {SceneKind::solid, SceneKind::coupled}) {
    Case c = restless_droplet(kind);
    c.domain.elements = {6, 6};
    c.substrate->strain = Strain::small;
    c.substrate->branches = {{0.9, 0.3}, {1.7, 0.004}};
    c.time.scheme = TimeScheme::kick_drift;
    c.time.tolerance = 1e30;
    c.time.dt_initial = 1;
    expect_same_bits(c, 8);
  }
}
TEST(StepMemory, ExplicitRunsOfASolidGoOn) {
  expect_same_explicit_bits(TimeScheme::kick_drift, SceneKind::solid, false);
}

}  // namespace
}  // namespace softwet::testing_tools
