// How many kernels and copies an explicit step starts, and how often it waits for them. On a device each costs some
// microseconds, however small the scene is.
#include <cstdlib>

#include "time/explicit/explicit_scheme.hpp"
#include "unit/time/launches.hpp"

namespace softwet::testing_tools {
namespace {

// Whoever adds one sees it here. On the host a term is several launches, and no others share one.
TEST(Launches, AnExplicitStepIsFewOfThemAndOneWait) {
  const Counts rigid = counts_of_a_step<2>(small_case(SceneKind::rigid, WallLaw::energy));
  EXPECT_LE(sum(rigid.kernels), host_algorithms ? 34 : 30);
  EXPECT_EQ(sum(rigid.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(rigid.waits), 1);
  const Counts coupled = counts_of_a_step<2>(small_case(SceneKind::coupled, WallLaw::energy));
  EXPECT_LE(sum(coupled.kernels), host_algorithms ? 48 : 39);
  EXPECT_EQ(sum(coupled.copies), on_host ? 0 : 1);
  EXPECT_EQ(sum(coupled.waits), 1);
}

/// Takes steps that are recorded. What they ask of a device is counted by tests/device/host_code.py: the difference
/// between two runs with unlike numbers of steps.
void take_recorded_steps(SceneKind kind) {
  const char* steps = std::getenv("SOFTWET_TEST_STEPS");
  Case c = small_case(kind, WallLaw::energy);
  c.time.scheme = TimeScheme::kick_drift;
  c.time.end = 1;
  c.time.dt_max = c.time.dt_initial = 1e-3;
  for (Load& load : c.loads) load.start = 0;
  c.solver.launch = Launch::graph;
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  take_first_steps(stepper, scene, c);
  for (int n = steps ? std::atoi(steps) : 3; n > 0; --n) stepper.step();
  const auto& scheme = dynamic_cast<ExplicitScheme<2, 2>&>(stepper.scheme());
  EXPECT_EQ(scheme.recordings(), host_algorithms ? 0 : 2);
}

TEST(RecordedLaunches, OfARigidWall) { take_recorded_steps(SceneKind::rigid); }
TEST(RecordedLaunches, OfASoftLayer) { take_recorded_steps(SceneKind::coupled); }

}  // namespace
}  // namespace softwet::testing_tools
