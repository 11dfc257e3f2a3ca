// Needles in 2D and in the coordinates (r, z).
#include "unit/scene/needle_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Needles, ForceEnergyPowerAndProduct) {
  for (const Scene kind : {Scene::solid, Scene::coupled}) {
    check_needles<2>(scene(kind));
    check_needles<2>(scene(kind, WallLaw::energy, true));
    check_needles<2>(axisymmetric(scene(kind)));
  }
}

TEST(Needles, ReadForceTimesVolume) {
  check_reading<2>(scene(Scene::solid));
  check_reading<2>(scene(Scene::solid, WallLaw::energy, true));
  check_reading<2>(axisymmetric(scene(Scene::solid)));
}

TEST(Needles, AreOnTheDiagonalOfTheMatrix) {
  check_matrix<2>(scene(Scene::coupled));
  check_matrix<2>(axisymmetric(scene(Scene::solid)));
}

TEST(Needles, StandStillBeforeTheClockOfResults) {
  const Case c = with_needles(scene(Scene::solid));
  const Model<2, 2> model(c);
  State state = empty_state(model.layout());
  for (const double before : {0.0, 0.7}) {
    state.time = c.clock_zero() - before;
    const NeedleReading reading = model.needle_readings(stage_at(model.layout(), state))[0];
    EXPECT_EQ(reading.force[0], 0);
    EXPECT_EQ(reading.power, 0);
  }
}

TEST(Needles, OfNoCaseAreNone) {
  const Model<2, 2> model(scene(Scene::coupled));
  EXPECT_TRUE(model.needles().empty());
  EXPECT_EQ(model.rates_of_solid().held, 0);
}

TEST(Needles, StiffnessAddsUpWhereTheyOverlap) {
  Case c = with_needles(scene(Scene::solid));
  EXPECT_EQ((Model<2, 2>(c).rates_of_solid().held), stiff + soft);
  c.needles[1].lower[0] = c.needles[0].upper[0];
  EXPECT_EQ((Model<2, 2>(c).rates_of_solid().held), stiff);
}

}  // namespace
}  // namespace softwet::testing_tools
