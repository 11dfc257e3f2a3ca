// Needles in 2D and in the coordinates (r, z).
#include "unit/scene/needle_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Needles, ForceEnergyPowerAndProduct) {
  for (const SceneKind kind : {SceneKind::solid, SceneKind::coupled}) {
    check_needles<2>(small_case(kind));
    check_needles<2>(small_case(kind, WallLaw::energy, true));
    check_needles<2>(axisymmetric(small_case(kind)));
  }
}

TEST(Needles, ReadForceTimesVolume) {
  check_reading<2>(small_case(SceneKind::solid));
  check_reading<2>(small_case(SceneKind::solid, WallLaw::energy, true));
  check_reading<2>(axisymmetric(small_case(SceneKind::solid)));
}

TEST(Needles, AreOnTheDiagonalOfTheMatrix) {
  check_matrix<2>(small_case(SceneKind::coupled));
  check_matrix<2>(axisymmetric(small_case(SceneKind::solid)));
}

TEST(Needles, StandStillBeforeTheClockOfResults) {
  const Case c = with_needles(small_case(SceneKind::solid));
  const Scene<2, 2> scene(c);
  State state = empty_state(scene.layout());
  for (const double before : {0.0, 0.7}) {
    state.time = c.clock_zero() - before;
    const NeedleReading reading = scene.balance().measure(stage_at(scene.layout(), state)).needles[0];
    EXPECT_EQ(reading.force[0], 0);
    EXPECT_EQ(reading.power, 0);
  }
}

TEST(Needles, OfNoCaseAreNone) {
  const Scene<2, 2> scene(small_case(SceneKind::coupled));
  EXPECT_TRUE(scene.forces().needles().empty());
  EXPECT_EQ(scene.coefficients().solid().rates.held, 0);
}

TEST(Needles, StiffnessAddsUpWhereTheyOverlap) {
  Case c = with_needles(small_case(SceneKind::solid));
  EXPECT_EQ((Scene<2, 2>(c).coefficients().solid().rates.held), stiff + soft);
  c.needles[1].lower[0] = c.needles[0].upper[0];
  EXPECT_EQ((Scene<2, 2>(c).coefficients().solid().rates.held), stiff);
}

}  // namespace
}  // namespace softwet::testing_tools
