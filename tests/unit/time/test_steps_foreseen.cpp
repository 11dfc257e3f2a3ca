// The number of explicit steps that is foreseen from the numbers of a case, against the bound of its first state.
#include "time/steps_foreseen.hpp"

#include "unit/time/explicit_run.hpp"

namespace softwet::testing_tools {
namespace {

/// Steps foreseen over those by the bound of the first state.
double ratio(Case c) {
  c.time.end = 1;
  const double start = c.run_start() - c.clock_zero();
  return explicit_steps_foreseen(c) * c.time.safety /
         ((c.time.end - start) * ExplicitRun(c, "kick_drift").rates().combined);
}

// In so small a box the vapour around a droplet is denser than foreseen, the more so the colder it is.
TEST(StepsForeseen, AreAtLeastThoseOfTheFirstState) {
  for (const auto& [temperature, most] : {std::pair{0.95, 1.2}, {0.85, 1.3}, {0.7, 1.35}, {0.5, 1.6}}) {
    Case c = moving_droplet(Scene::rigid);
    c.domain.elements = {36, 24};
    c.fluid->capillarity = 0.04;  // so narrow that there is vapour of its equilibrium density
    c.fluid->temperature = temperature;
    Case stabilised = c;
    stabilised.fluid->stabilisation = 1;
    for (const Case& one : {c, around_axis(c), stabilised}) {
      EXPECT_GT(ratio(one), 0.95) << temperature;
      EXPECT_LT(ratio(one), most) << temperature;
    }
  }
  EXPECT_NEAR(ratio(moving_droplet(Scene::solid)), 1, 0.15);
  Case inside = moving_droplet(Scene::rigid);
  inside.domain.elements = {36, 24};
  inside.fluid->capillarity = 0.04;
  inside.fluid->temperature = 0.85;
  inside.fluid->contact_angle = 90;
  inside.droplets = {{{0.45, 0.4}, 0.25}};
  EXPECT_NEAR(ratio(inside), 1, 0.15) << "it touches no side";
}

TEST(StepsForeseen, FollowTheTimeFromTheFirstStateToTheEnd) {
  Case c = moving_droplet(Scene::coupled);
  c.time.end = 2;
  const double once = explicit_steps_foreseen(c);
  c.time.end = 4;
  EXPECT_NEAR(explicit_steps_foreseen(c), 2 * once, 1e-9 * once);
  c.loads.front().start = 1;  // t = 0 is then
  EXPECT_NEAR(explicit_steps_foreseen(c), 2.5 * once, 1e-9 * once);
  c.time.safety /= 2;
  EXPECT_NEAR(explicit_steps_foreseen(c), 5 * once, 1e-9 * once);
}

}  // namespace
}  // namespace softwet::testing_tools
