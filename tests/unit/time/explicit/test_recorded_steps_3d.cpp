// Steps of kick_drift in 3D that are recorded.
#include "unit/scene/scenes.hpp"
#include "unit/time/recorded_run.hpp"

namespace softwet::testing_tools {
namespace {

TEST(RecordedSteps, KeepTheirBitsIn3d) {
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled})
    EXPECT_EQ(recordings_with_same_bits<3>(small_case_in_3d(kind, WallLaw::energy), 5), two());
}

TEST(RecordedSteps, FollowBranchesIn3d) {
  Case c = small_case_in_3d(SceneKind::coupled, WallLaw::energy);
  c.substrate->strain = Strain::finite;
  c.substrate->branches = {{0.9, 0.3}};
  EXPECT_EQ(recordings_with_same_bits<3>(c, 5), two());
}

}  // namespace
}  // namespace softwet::testing_tools
