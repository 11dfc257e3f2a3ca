// The bound of the step against the largest stable step of the linearised scheme.
#include "unit/time/explicit/step_room.hpp"

namespace softwet::testing_tools {
namespace {

/// A droplet at rest away from all sides, in a box.
Case droplet_inside(double temperature) {
  Case c = moving_droplet(SceneKind::rigid);
  c.domain.size = {1, 1};
  c.domain.elements = {32, 32};
  c.fluid->temperature = temperature;
  c.fluid->contact_angle = 90;
  c.fluid->capillarity = 1.0 / 24;
  c.fluid->viscosity = 5e-4;
  c.boundary.side[1] = {Side::slip, Side::slip};
  c.droplets = {{{0.5, 0.5}, 0.28}};
  return c;
}

TEST(StepBound, IsCloseForADropletInside) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped}) {
    const double found = room(droplet_inside(0.85), TimeScheme::kick_drift, kind);
    EXPECT_GE(found, 1);
    EXPECT_LE(found, 1.3);
  }
}
TEST(StepBound, HoldsForOtherSchemes) {
  for (const TimeScheme scheme : {TimeScheme::ssp_rk3, TimeScheme::rkl2})
    EXPECT_GE(room(droplet_inside(0.85), scheme), 1) << word_of(scheme);
}
TEST(StepBound, HoldsForADropletOnAWallAndInACorner) {
  for (const double x : {0.5, 0.0}) {
    Case c = droplet_inside(0.85);
    c.droplets = {{{x, 0.0}, 0.35}};
    const double found = room(c, TimeScheme::kick_drift);
    EXPECT_GE(found, 1);
    EXPECT_LE(found, 1.4);
  }
}
TEST(StepBound, HoldsWhereTheStabilisationLimitsIt) {
  Case c = droplet_inside(0.85);
  c.domain.size = {0.5, 0.5};
  c.droplets = {{{0.0, 0.0}, 0.22}};
  c.fluid->stabilisation = Fluid{}.stabilisation;
  for (const double viscosity : {3e-4, 3e-5}) {  // the smaller, the more it stabilises
    c.fluid->viscosity = viscosity;
    for (const MassKind kind : {MassKind::corrected, MassKind::lumped}) {
      const double found = room(c, TimeScheme::kick_drift, kind);
      EXPECT_GE(found, 1) << viscosity;
      EXPECT_LE(found, 1.6) << viscosity;
    }
  }
  EXPECT_GE(room(c, TimeScheme::ssp_rk3), 1);
}
TEST(StepBound, HoldsInASolidAndAboveOne) {
  EXPECT_GE(room(moving_droplet(SceneKind::solid), TimeScheme::kick_drift), 1);
  EXPECT_GE(room(moving_droplet(SceneKind::coupled), TimeScheme::kick_drift), 1);
}

TEST(StepBound, HoldsAroundAnAxisOfSymmetry) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped}) {
    Case c = axisymmetric(droplet_inside(0.85));
    c.droplets = {{{0.0, 0.5}, 0.28}};  // a ball
    EXPECT_GE(room(c, TimeScheme::kick_drift, kind), 1);
    c.droplets = {{{0.0, 0.0}, 0.35}};  // half of one, on a wall
    const double found = room(c, TimeScheme::kick_drift, kind);
    EXPECT_GE(found, 1);
    EXPECT_LE(found, 1.4);
    EXPECT_GE(room(around_axis(moving_droplet(SceneKind::coupled)), TimeScheme::kick_drift, kind), 1);
    for (const double poisson : {0.0, 0.3, 0.45}) {
      Case solid = around_axis(moving_droplet(SceneKind::solid));
      solid.substrate->poisson = poisson;
      EXPECT_GE(room(solid, TimeScheme::kick_drift, kind), 1) << poisson;
      solid.substrate->viscosity = 0.1;
      EXPECT_GE(room(solid, TimeScheme::kick_drift, kind), 1) << poisson << ", viscous";
    }
  }
}

TEST(StepBound, MechanismsFollowTheirNumbers) {
  const Case c = droplet_inside(0.85);
  const StepRates before = ExplicitRun(c, TimeScheme::kick_drift).rates();
  Case viscous = c, thick = c;
  viscous.fluid->viscosity *= 2;
  EXPECT_NEAR(ExplicitRun(viscous, TimeScheme::kick_drift).rates().viscosity / before.viscosity, 2, 1e-12);
  EXPECT_NEAR(ExplicitRun(viscous, TimeScheme::kick_drift).rates().sound / before.sound, 1, 1e-12);
  thick.domain.elements = {64, 64};
  EXPECT_NEAR(ExplicitRun(thick, TimeScheme::kick_drift).rates().capillarity / before.capillarity, 4, 0.2);
}

}  // namespace
}  // namespace softwet::testing_tools
