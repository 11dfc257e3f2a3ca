// Needles in 3D.
#include "unit/scene/needle_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Needles3D, ForceEnergyPowerAndProduct) {
  check_needles<3>(small_case_in_3d(SceneKind::solid));
  check_needles<3>(small_case_in_3d(SceneKind::coupled));
}
TEST(Needles3D, ReadForceTimesVolume) { check_reading<3>(small_case_in_3d(SceneKind::solid)); }
TEST(Needles3D, AreOnTheDiagonalOfTheMatrix) { check_matrix<3>(small_case_in_3d(SceneKind::coupled)); }

}  // namespace
}  // namespace softwet::testing_tools
