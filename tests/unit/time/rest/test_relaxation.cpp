// Scenes that are brought to rest: conserved quantities, the end, and refused scenes.
#include "time/rest/relaxation.hpp"

#include <algorithm>

#include "case/error.hpp"
#include "scene/initial.hpp"
#include "time/rest/rest_control.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

double mass_of(const Scene<2, 2>& scene, const State& s) {
  return scene.balance().measure(stage_at(scene.layout(), s)).integrals["mass"];
}

TEST(Relaxation, ASolidLayerUnderNoLoadReturnsToItsReference) {
  Case c = small_case(SceneKind::solid);
  c.loads.clear();
  c.waves = {{WaveField::displacement_x, 1e-3, {1, 1}}};
  const Scene<2, 2> scene(c);
  State s = initial_state<2, 2>(c, scene);
  s.time = 7;
  const double before = norm(alone, s.displacement);
  ASSERT_GT(before, 1e-3);
  const Relaxation done = relax<2, 2>(scene, c, s);
  EXPECT_LT(norm(alone, s.displacement), 0.05 * before);
  EXPECT_LT(done.rate, 1e-6);
  EXPECT_EQ(s.time, 7.0);
}

// Twice at rest is once at rest: the second time finds nothing to do, and the mass is what it was in the beginning.
TEST(Relaxation, KeepsTheMassAndFindsItsOwnEndAtRest) {
  const Case c = small_case(SceneKind::coupled);
  const Scene<2, 2> scene(c);
  State s = initial_state<2, 2>(c, scene);
  const double mass = mass_of(scene, s);
  const Relaxation first = relax<2, 2>(scene, c, s);
  EXPECT_NEAR(mass_of(scene, s), mass, 1e-11 * mass);
  const std::vector<double> at_rest = to_host(s.unknown);
  const Relaxation second = relax<2, 2>(scene, c, s);
  EXPECT_LT(second.time, first.time);
  const Layout<2>& l = scene.layout();
  const std::vector<double> again = to_host(s.unknown);
  for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(again[i], at_rest[i], 1e-3);
}

// Slowly, through a thin interface, the vapour fills until it has the chemical potential of the droplet. It may stop no
// sooner: the missing mass is compared with the small density of the vapour.
TEST(Relaxation, EndsWhenTheVapourHasFilled) {
  Case c = small_case(SceneKind::rigid, WallLaw::energy);
  c.domain = {.size = {1.0, 0.5}, .elements = {24, 12}, .degree = 2};
  c.fluid->viscosity = 1.0 / 256;
  c.fluid->capillarity = 1.0 / 12;
  c.fluid->temperature = 0.39;
  c.fluid->stabilisation = 0.02;
  c.droplets = {{{0.5, 0.0}, 0.25}};
  const Scene<2, 2> scene(c);
  State s = initial_state<2, 2>(c, scene);
  const Relaxation done = relax<2, 2>(scene, c, s);
  const Layout<2>& l = scene.layout();
  const auto potential = part(ConstArray(s.unknown), l.potential_offset(), l.size());
  const std::vector<double> mu = to_host(potential);
  const auto [least, most] = std::minmax_element(mu.begin(), mu.end());
  // d mu = (8/27) theta d rho / rho in the vapour.
  const double vapour = (*most - *least) / (8.0 / 27 * c.fluid->temperature);
  std::printf("  %ld steps, the vapour is off by %.2e of its density\n", done.steps, vapour);
  EXPECT_LT(vapour, 1e-3);
}

// The result is a state of rest to the last digits, whatever the tolerance, and the mass is kept.
TEST(Relaxation, LeavesNothingButRoundOff) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid}) {
    Case c = small_case(kind, WallLaw::energy);
    c.fluid->smoothing = 1e-4;
    const Scene<2, 2> scene(c);
    State s = initial_state<2, 2>(c, scene);
    const double mass = mass_of(scene, s);
    const Relaxation done = relax<2, 2>(scene, c, s);
    EXPECT_EQ(done.why, "");
    EXPECT_LT(done.excess, 8);
    EXPECT_NEAR(mass_of(scene, s), mass, 1e-12 * mass);
    EXPECT_LT(norm(alone, part(ConstArray(s.unknown), 0, scene.layout().velocity_size())), 1e-10);
    EXPECT_LT(done.steps, 30);
  }
}

// The load of the time of the state acts, though steps are endless: no time passes in them.
TEST(Relaxation, RestsUnderTheLoadsOfItsTime) {
  const Case c = small_case(SceneKind::solid);
  const Scene<2, 2> scene(c);
  const auto rest_at = [&](double time) {
    State s = initial_state<2, 2>(c, scene);
    s.time = time;
    EXPECT_EQ((relax<2, 2>(scene, c, s).why), "");
    EXPECT_EQ(s.time, time);
    return norm(alone, s.displacement);
  };
  const Load& load = c.loads[0];
  EXPECT_LT(rest_at(load.start), 1e-14);
  const double whole = rest_at(load.start + load.ramp), half = rest_at(load.start + 0.5 * load.ramp);
  EXPECT_GT(half, 0);
  EXPECT_NEAR(half / whole, 0.5, 0.1);  // up to nonlinear terms
}

// On a coarse mesh a droplet that was put off the middle creeps there in 1e5 units of time, by a part of an element in
// a step. It is followed to the end: small rates of change alone are not rest.
TEST(Relaxation, FollowsADropletThatCreeps) {
  Case c = small_case(SceneKind::coupled);
  c.domain = {.size = {1.0, 0.5}, .elements = {32, 16}, .degree = 2};
  c.fluid->viscosity = 1.0 / 256;
  c.fluid->capillarity = 1.0 / 16;
  c.fluid->temperature = 0.39;
  c.fluid->contact_angle = 84.2;
  c.fluid->stabilisation = 0.002;
  c.fluid->smoothing = 1e-4;
  c.substrate->thickness = 0.125;
  c.substrate->density = 1;
  c.substrate->young = 1.471;
  c.substrate->poisson = 0.295;
  c.loads.clear();
  c.droplets = {{{0.58, 0.125}, 0.1287}};
  c.boundary.side[0] = {Side::slip, Side::slip};
  const Scene<2, 2> scene(c);
  State s = initial_state<2, 2>(c, scene);
  const Relaxation done = relax<2, 2>(scene, c, s);
  EXPECT_EQ(done.why, "");
  EXPECT_LT(done.excess, digits_of_rest);
  EXPECT_LE(done.rejected, done.steps);
  std::printf("  %ld steps, %ld refused\n", done.steps, done.rejected);
}

// Along a periodic axis nothing holds a droplet that a force drives.
TEST(Relaxation, SaysThatADrivenDropletDoesNotRest) {
  Case c = small_case(SceneKind::rigid, WallLaw::energy, true);
  c.fluid->gravity = {0.5, 0};
  c.droplets = {{{0.45, 0.0}, 0.3}};
  const Scene<2, 2> scene(c);
  State s = initial_state<2, 2>(c, scene);
  EXPECT_NE((relax<2, 2>(scene, c, s).why), "");
}

}  // namespace
}  // namespace softwet::testing_tools
