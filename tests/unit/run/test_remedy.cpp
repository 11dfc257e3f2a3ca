// What a user is advised after a computation that stopped: unusual settings come before the scene.
#include "run/remedy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// A solid so soft that it is blamed where the settings are usual.
Case soft() {
  Case c = small_case(SceneKind::coupled);
  c.substrate->young = 1e-3;
  c.droplets = {{{0.45, c.substrate->thickness}, 0.2}};
  return c;
}

bool blames(const std::string& advice, const std::string& what) { return advice.find(what) != std::string::npos; }

TEST(Remedy, BlamesASoftSolidWhereTheSettingsAreUsual) {
  for (auto cause : {Refusal::newton, Refusal::solid_inverted})
    EXPECT_TRUE(blames(remedy(soft(), {cause}, 0), "young"));
}

/// A number until a time, and none from then on.
struct EndsAt final : Formula {
  explicit EndsAt(double end) : last(end) {}
  double at(const std::array<double, 3>&, double t) const override { return std::sqrt(last - t); }
  double last;
};

TEST(Remedy, ALoadThatIsNoNumberIsCalledByItsName) {
  Case c = soft();
  c.loads.resize(2);
  for (Load& load : c.loads) load.factor = 1;
  c.loads[1].factor.formula = std::make_shared<EndsAt>(3);
  EXPECT_TRUE(blames(remedy(c, {Refusal::not_finite}, 3), "load[1].factor is not a number after t = 3"));
  EXPECT_FALSE(blames(remedy(c, {Refusal::not_finite}, 2), "load[1]"));
  c.loads[1].factor = 1;
  c.loads[0].path = {Profile(0), Profile(0)};
  c.loads[0].path[1].formula = std::make_shared<EndsAt>(3);
  EXPECT_TRUE(blames(remedy(c, {Refusal::newton}, 3), "load[0].path is not a number after t = 3"));
}

TEST(Remedy, ASoftSolidIsBroughtToRestBeforeItIsMadeStiffer) {
  Case c = soft();
  const std::string advice = remedy(c, {Refusal::solid_inverted}, 0);
  for (const char* part : {"time.start = \"equilibrium\"", "softwet steady", "substrate.viscosity"})
    EXPECT_LT(advice.find(part), advice.find("raise substrate.young")) << part;
  c.time.start = StartState::equilibrium;
  EXPECT_FALSE(blames(remedy(c, {Refusal::solid_inverted}, 0), "time.start")) << "it does so already";
  c.substrate->young = 1e3;
  EXPECT_FALSE(blames(remedy(c, {Refusal::solid_inverted}, 0), "substrate.viscosity")) << "it is not soft";
}

TEST(Remedy, ASceneWithoutLoadsIsNotToldOfTheirRamp) {
  for (auto cause : {Refusal::newton, Refusal::negative_density, Refusal::solid_inverted}) {
    Case c = small_case(SceneKind::coupled);
    c.loads.clear();
    c.needles.clear();
    c.fluid->capillarity = 2 * c.spacing();  // enough, so that it is not blamed
    EXPECT_FALSE(blames(remedy(c, {cause}, 0), "load")) << remedy(c, {cause}, 0);
    c.loads.resize(1);
    c.loads[0].factor = 1;
    EXPECT_TRUE(blames(remedy(c, {cause}, 0), "load[].ramp")) << remedy(c, {cause}, 0);
  }
}

TEST(Remedy, LinesThatStickAreToldTheSpeedOfTheirCreep) {
  Case c = small_case(SceneKind::coupled);
  c.fluid->contact_angle_range = {65, 85};
  c.fluid->creep_speed = 2e-5;
  EXPECT_TRUE(blames(remedy(c, {Refusal::newton}, 0), "a larger fluid.creep_speed than 2e-05, for example 0.0002"));
  c.fluid->contact_angle_range = {};
  EXPECT_FALSE(blames(remedy(c, {Refusal::newton}, 0), "creep_speed"));
}

TEST(Remedy, UnusualSettingsComeFirst) {
  for (auto cause : {Refusal::newton, Refusal::solid_inverted, Refusal::negative_density, Refusal::linear_solver}) {
    Case loose = soft(), few = soft(), long_steps = soft(), linear = soft();
    loose.solver.newton_rtol = 0.5;
    few.solver.newton_max = 2;
    long_steps.time.dt_min = 0.6;
    linear.solver.krylov_max = 3;
    EXPECT_TRUE(blames(remedy(loose, {cause}, 0), "solver.newton.rtol = 0.5 (default 0.001)"));
    EXPECT_TRUE(blames(remedy(few, {cause}, 0), "solver.newton.max = 2 (default 10)"));
    EXPECT_TRUE(blames(remedy(long_steps, {cause}, 0), "time.dt_min = 0.6 (default 1e-08)"));
    EXPECT_TRUE(blames(remedy(linear, {cause}, 0), "solver.krylov.max = 3 (default 200)"));
    for (const Case& c : {loose, few, long_steps, linear}) EXPECT_FALSE(blames(remedy(c, {cause}, 0), "young"));
  }
}

TEST(Remedy, SettingsOfNewtonsMethodDoNotConcernExplicitSchemes) {
  Case c = soft();
  c.time.scheme = TimeScheme::ssp_rk3;
  c.solver.newton_max = 2;
  EXPECT_FALSE(blames(remedy(c, {Refusal::negative_density}, 0), "newton"));
}

}  // namespace
}  // namespace softwet::testing_tools
