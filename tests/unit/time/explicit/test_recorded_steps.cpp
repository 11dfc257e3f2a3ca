// Steps of kick_drift that are recorded. Without a device a recording starts its kernels one by one, with the arguments
// at the time of recording: so these tests show that all numbers that change from step to step are read in memory.
#include "operator/device/collect.hpp"
#include "operator/device/stored_bytes.hpp"
#include "unit/scene/formulas.hpp"
#include "unit/time/explicit_run.hpp"
#include "unit/time/recorded_run.hpp"

namespace softwet::testing_tools {
namespace {

TEST(RecordedSteps, KeepTheirBits) {
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled, SceneKind::solid})
    EXPECT_EQ(recordings_with_same_bits<2>(moving_droplet(kind)), two());
  EXPECT_EQ(recordings_with_same_bits<2>(moving_droplet(SceneKind::coupled, true)), two());
  EXPECT_EQ(recordings_with_same_bits<2>(around_axis(moving_droplet(SceneKind::coupled))), two());
}

TEST(RecordedSteps, KeepTheirBitsWithLumpedMasses) {
  Case c = moving_droplet(SceneKind::coupled);
  c.time.mass = MassKind::lumped;
  EXPECT_EQ(recordings_with_same_bits<2>(c), two());
}

// Searches of consistent masses wait for the host, and Runge-Kutta schemes have their numbers as arguments.
TEST(RecordedSteps, AreThoseOfKickDriftWithoutSearchesAlone) {
  Case c = moving_droplet(SceneKind::coupled);
  c.time.mass = MassKind::consistent;
  EXPECT_EQ(recordings_with_same_bits<2>(c, 4), 0);
}

TEST(RecordedSteps, FollowBranches) {
  for (const Strain strain : {Strain::small, Strain::finite}) {
    Case c = moving_droplet(SceneKind::coupled);
    c.substrate->strain = strain;
    c.substrate->branches = {{0.9, 0.3}, {1.7, 0.04}};
    EXPECT_EQ(recordings_with_same_bits<2>(c), two());
  }
}

TEST(RecordedSteps, FollowForcesThatGrowAndMove) {
  const auto steady = [](double speed) {
    return varying([speed](const std::array<double, 3>&, double t) { return speed * t; });
  };
  Case c = moving_droplet(SceneKind::coupled);
  c.loads[0].factor = varying([](const std::array<double, 3>&, double t) { return 1 - 20 * t * t; });
  c.loads.push_back(c.loads[0]);
  c.loads[1].path = {steady(0.3), Profile(0)};
  c.needles.push_back({{0.0, 0.0}, {0.2, 0.1}, 5.0, {steady(0.2), steady(-0.1)}});
  EXPECT_EQ(recordings_with_same_bits<2>(c), two());
}

// A load that begins to act starts a kernel more.
TEST(RecordedSteps, AreRecordedAgainWhereALoadBegins) {
  Case c = moving_droplet(SceneKind::coupled);
  RunOfSteps<2> probe(c, Launch::kernels);
  probe.step(5);
  c.loads[0].start = probe.stepper.state().time;
  EXPECT_EQ(recordings_with_same_bits<2>(c, 13), 2 * two());
}

// Other evaluations may ask for more room, and for more tables than a device keeps.
TEST(RecordedSteps, AreRecordedAgainWhereMemoryHasMoved) {
  if (host_algorithms) GTEST_SKIP() << "on the host nothing is recorded";
  RunOfSteps<2> run(moving_droplet(SceneKind::rigid), Launch::graph);
  run.step(6);
  EXPECT_EQ(run.scheme().recordings(), 2);
  const long moves = moves_of_tile_rooms;
  Case larger = moving_droplet(SceneKind::rigid);
  larger.domain.elements = {90, 60};
  RandomSceneIn<2> other(larger);
  const Array out("out", other.layout().size());
  other.scene.equations().residual(other.stage(), out);
  EXPECT_GT(moves_of_tile_rooms, moves);
  run.step(2);
  EXPECT_EQ(run.scheme().recordings(), 2) << "kernels start one by one the first time";
  run.step(6);  // whose tables may have taken the places of others
  EXPECT_EQ(run.scheme().recordings(), 4);
}

TEST(RecordedSteps, TablesThatAreReplacedCount) {
  const long before = replaced_copies_of_bytes();
  for (int table = 0; table < 40; ++table) {
    const std::vector<std::byte> bytes(16, std::byte(table));
    stored_bytes(bytes.data(), bytes.size());
  }
  EXPECT_GE(replaced_copies_of_bytes(), before + 24);
}

}  // namespace
}  // namespace softwet::testing_tools
