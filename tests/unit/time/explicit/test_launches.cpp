// How many kernels and copies an explicit step starts, and how often it waits for them. On a device each costs some
// microseconds, however small the scene is.
#include "unit/time/launches.hpp"

namespace softwet::testing_tools {
namespace {

// Whoever adds one sees it here. On the host a term is several launches, and no others share one.
TEST(Launches, AnExplicitStepIsFewOfThemAndOneWait) {
  const Counts rigid = counts_of_a_step<2>(scene(Scene::rigid, WallLaw::energy));
  EXPECT_LE(sum(rigid.kernels), host_algorithms ? 34 : 30);
  EXPECT_EQ(sum(rigid.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(rigid.waits), 1);
  const Counts coupled = counts_of_a_step<2>(scene(Scene::coupled, WallLaw::energy));
  EXPECT_LE(sum(coupled.kernels), host_algorithms ? 48 : 39);
  EXPECT_EQ(sum(coupled.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(coupled.waits), 1);
}

}  // namespace
}  // namespace softwet::testing_tools
