// How many kernels and copies a row of history.csv starts, and how often it waits for them.
#include "observe/scalars.hpp"
#include "unit/observe/core/homogeneous.hpp"
#include "unit/time/launches.hpp"

namespace softwet::testing_tools {
namespace {

/// Counts of the second row: the first one allocates the sums and the copies.
Counts counts_of_a_row(const Case& c) {
  Homogeneous s(c, {{{0.05, 0.01}, {0, -0.02}}});
  s.state.time = 3;  // loads act
  Scalars<2, 2> scalars(s.data, s.scene);
  scalars.row_of(scalars.read(0, {}, s.state, s.stage()));
  return counts_of([&] { scalars.row_of(scalars.read(1, {}, s.state, s.stage())); });
}

TEST(Launches, ARowIsFewOfThemAndOneWait) {
  const Counts rigid = counts_of_a_row(small_case(SceneKind::rigid, WallLaw::energy));
  EXPECT_LE(sum(rigid.kernels), 3);
  EXPECT_EQ(sum(rigid.copies), on_host ? 0 : 2);  // numbers, and density with potential
  EXPECT_EQ(sum(rigid.waits), 1);
  const Counts coupled = counts_of_a_row(small_case(SceneKind::coupled, WallLaw::energy));
  EXPECT_LE(sum(coupled.kernels), 6 + 2);           // a load acts along two axes
  EXPECT_EQ(sum(coupled.copies), on_host ? 0 : 3);  // and the displacement
  EXPECT_EQ(sum(coupled.waits), 1);
}

// Loads that act, gravity and needles are sums of their own, but no waits.
TEST(Launches, ForcesOfARowAddNoWait) {
  Case c = small_case(SceneKind::coupled, WallLaw::energy);
  c.substrate->gravity = {0.3, -0.8};
  Needle needle;
  needle.lower = {0.2, 0.0}, needle.upper = {0.4, 0.1};
  needle.stiffness = 3;
  c.needles = {needle};
  const Counts row = counts_of_a_row(c);
  EXPECT_EQ(row.kernels.at("softwet::sums"), 2 + 2 + 2 * 3);  // of two axes each; a needle has three on each
  EXPECT_EQ(sum(row.waits), 1);
}

}  // namespace
}  // namespace softwet::testing_tools
