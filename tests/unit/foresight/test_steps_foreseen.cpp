// The number of explicit steps that is foreseen from the numbers of a case, against the bound of its first state.
#include "foresight/steps_foreseen.hpp"

#include "unit/time/explicit_run.hpp"

namespace softwet::testing_tools {
namespace {

/// Steps foreseen over those by the bound of the first state.
template <int D = 2>
double ratio(Case c) {
  c.time.end = 1;
  const double start = c.run_start() - c.clock_zero();
  return explicit_steps_foreseen(c) * c.time.safety /
         ((c.time.end - start) * ExplicitRunIn<D>(c, TimeScheme::kick_drift).rates().combined);
}

// In so small a box the vapour around a droplet is denser than foreseen, the more so the colder it is.
TEST(StepsForeseen, AreAtLeastThoseOfTheFirstState) {
  for (const auto& [temperature, most] : {std::pair{0.95, 1.2}, {0.85, 1.3}, {0.7, 1.35}, {0.5, 1.6}}) {
    Case c = moving_droplet(SceneKind::rigid);
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
  EXPECT_NEAR(ratio(moving_droplet(SceneKind::solid)), 1, 1e-12);
  Case inside = moving_droplet(SceneKind::rigid);
  inside.domain.elements = {36, 24};
  inside.fluid->capillarity = 0.04;
  inside.fluid->temperature = 0.85;
  inside.fluid->contact_angle = 90;
  inside.droplets = {{{0.45, 0.4}, 0.25}};
  EXPECT_NEAR(ratio(inside), 1, 0.15) << "it touches no side";
}

// Each makes the steps of a solid many times shorter than its elasticity does. The first state is not deformed.
TEST(StepsForeseen, KnowAllThatLimitsASolid) {
  const auto solids = [](const Case& plain) {
    std::vector<Case> all(9, plain);
    for (Case& c : all) c.loads.clear();
    for (const int k : {0, 2}) all[k].substrate->fibre = {300, 80, 30};
    for (const int k : {1, 2}) all[k].substrate->surface_tension = all[k].substrate->surface_tension_wet = 20;
    all[3].substrate->viscosity = 2;
    all[3].substrate->bulk_viscosity = 1;
    all[4].boundary.side[0] = {Side::free, Side::free};
    all[5].domain.elements.back() = 2;
    all[6].substrate->surface_modulus = {10, 5};
    all[7].boundary.side[plain.dimension() - 1][0] = Side::free;
    all[7].parts.foundation.springs = {10, 500};
    all[8].boundary.side[plain.dimension() - 1][0] = Side::free;
    all[8].parts.foundation.dashpots = {1, 20};
    return all;
  };
  for (const Case& c : solids(small_case(SceneKind::solid))) {
    EXPECT_NEAR(ratio(c), 1, 1e-12);
    EXPECT_NEAR(ratio(axisymmetric(c)), 1, 1e-12);
  }
  for (const Case& c : solids(small_case_in_3d(SceneKind::solid))) EXPECT_NEAR(ratio<3>(c), 1, 1e-12);
  for (const MaterialModel material : {MaterialModel::neo_hookean, MaterialModel::saint_venant_kirchhoff}) {
    Case c = small_case(SceneKind::solid), deep = small_case_in_3d(SceneKind::solid);
    c.loads.clear(), deep.loads.clear();
    c.time.end = 1;
    c.substrate->material = deep.substrate->material = material;
    const double plain = explicit_steps_foreseen(c);
    c.substrate->prestretch = {1.15}, deep.substrate->prestretch = {1.15, 0.9};
    EXPECT_NEAR(ratio(c), 1, 1e-12) << word_of(material);
    EXPECT_NEAR(ratio(axisymmetric(c)), 1, 1e-12) << word_of(material);
    EXPECT_NEAR(ratio<3>(deep), 1, 1e-12) << word_of(material);
    // Along the stretch a layer becomes stiffer by this law, and a little softer by the other.
    if (c.substrate->material == MaterialModel::saint_venant_kirchhoff) {
      EXPECT_GT(explicit_steps_foreseen(c), 1.05 * plain);
    }
  }
  for (Case c : {moving_droplet(SceneKind::coupled), around_axis(moving_droplet(SceneKind::coupled))}) {
    c.substrate->fibre = {3000, 80, 0};
    EXPECT_NEAR(ratio(c), 1, 1e-12) << "below a droplet";
    c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.1;
    c.substrate->fibre.stiffness = 0;
    c.fluid->wall_tension = WallTensionModel::acts;
    c.substrate->density = 1e-3;
    EXPECT_NEAR(ratio(c), 1, 1e-12) << "with the tension of the wall";
  }
}

TEST(StepsForeseen, FollowTheTimeFromTheFirstStateToTheEnd) {
  Case c = moving_droplet(SceneKind::coupled);
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
