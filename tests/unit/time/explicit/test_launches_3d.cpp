// The launches of an explicit step in 3D.
#include "unit/time/launches.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Launches, AnExplicitStepIn3dIsFewOfThemAndOneWait) {
  const Counts rigid = counts_of_a_step<3>(small_case_in_3d(SceneKind::rigid, WallLaw::energy));
  EXPECT_LE(sum(rigid.kernels), host_algorithms ? 60 : 30);
  EXPECT_EQ(sum(rigid.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(rigid.waits), 1);
  const Counts coupled = counts_of_a_step<3>(small_case_in_3d(SceneKind::coupled, WallLaw::energy));
  EXPECT_LE(sum(coupled.kernels), host_algorithms ? 90 : 39);
  EXPECT_EQ(sum(coupled.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(coupled.waits), 1);
}

}  // namespace
}  // namespace softwet::testing_tools
