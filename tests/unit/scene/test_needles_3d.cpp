// Needles in space.
#include "unit/scene/needle_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Needles3D, ForceEnergyPowerAndProduct) {
  check_needles<3>(scene_in_space(Scene::solid));
  check_needles<3>(scene_in_space(Scene::coupled));
}
TEST(Needles3D, ReadForceTimesVolume) { check_reading<3>(scene_in_space(Scene::solid)); }
TEST(Needles3D, AreOnTheDiagonalOfTheMatrix) { check_matrix<3>(scene_in_space(Scene::coupled)); }

}  // namespace
}  // namespace softwet::testing_tools
