// Areas, centroids and connectedness of wetted regions, against formulas of plane and solid geometry.
#include "observe/wetted_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

/// A wall of one by one: `level` is positive under liquid, `lift` is the height of the wall.
template <class Level, class Lift>
WallSamples wall(int n, bool periodic, const Level& level, const Lift& lift) {
  WallSamples s{{1, 1}, {n, n}, {periodic, periodic}, {}, {}};
  for (int j = 0; j < s.points(1); ++j)
    for (int i = 0; i < s.points(0); ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      s.depth.push_back(level(x, y));
      s.displacement[0].push_back(0);
      s.displacement[1].push_back(0);
      s.displacement[2].push_back(lift(x, y));
    }
  return s;
}
double flat(double, double) { return 0; }

auto disc(double cx, double cy, double r) {
  return [=](double x, double y) { return r - std::hypot(std::remainder(x - cx, 1), std::remainder(y - cy, 1)); };
}

TEST(WettedWall, AreaOfACurvedWallIsOfSecondOrder) {
  // The paraboloid z = r^2 / 2 above a disc: 2 pi / 3 ((1 + a^2)^(3/2) - 1).
  const double a = 0.4, exact = 2 * M_PI / 3 * (std::pow(1 + a * a, 1.5) - 1);
  const auto lift = [](double x, double y) { return 0.5 * (std::pow(x - 0.5, 2) + std::pow(y - 0.5, 2)); };
  double before = 0;
  for (int n : {20, 40, 80}) {
    const WettedWall wetted(wall(n, false, disc(0.5, 0.5, a), lift));
    ASSERT_EQ(wetted.regions().size(), 1U);
    const double error = std::abs(wetted.regions()[0].area - exact);
    if (n > 20) {
      EXPECT_GT(before / error, 3.5) << n;
    }
    before = error;
    EXPECT_NEAR(wetted.regions()[0].centre[0], 0.5, 1e-13) << "by symmetry";
  }
  EXPECT_LT(before, 1e-3 * exact);
}

TEST(WettedWall, PlaneLevelsAreExact) {
  const WettedWall wetted(wall(
      7, false, [](double x, double y) { return 0.9 - x - 0.5 * y; }, [](double x, double) { return 0.75 * x; }));
  ASSERT_EQ(wetted.regions().size(), 1U);  // a trapezium with the corners (0, 0), (0.9, 0), (0.4, 1), (0, 1)
  const WettedRegion& region = wetted.regions()[0];
  EXPECT_NEAR(region.area, 1.25 * 0.65, 1e-14) << "the slope 3/4 stretches the wall by 5/4";
  EXPECT_NEAR(region.centre[0], (0.4 * 0.2 + 0.25 * (0.4 + 0.5 / 3)) / 0.65, 1e-14);
  EXPECT_NEAR(region.centre[1], (0.4 * 0.5 + 0.25 / 3) / 0.65, 1e-14);
  EXPECT_EQ(region.cut, (std::array<int, 2>{-1, 0})) << "ends on the low side of x, on both of y";
}

TEST(WettedWall, CutIsWhatASideHalvesNotWhatTouchesIt) {
  const auto cut = [](const auto& level) { return WettedWall(wall(40, false, level, flat)).regions().at(0).cut; };
  EXPECT_EQ(cut([](double x, double y) { return 0.3 - std::hypot(x - 0.5, y); }), (std::array<int, 2>{0, -1}));
  EXPECT_EQ(cut([](double x, double y) { return 0.3 - std::hypot(1 - x, y); }), (std::array<int, 2>{1, -1}));
  const auto bow = [](double x, double y) { return 0.1 - std::abs(std::hypot(x, y) - 0.7); };  // from side to side
  EXPECT_EQ(cut(bow), (std::array<int, 2>{0, 0}));
}

TEST(WettedWall, RegionsTouchThroughAWetMiddle) {
  const auto corners = [](double on) {
    return [on](double x, double y) { return x == y ? on : -1.0; };  // two opposite corners of the only cell
  };
  EXPECT_EQ(WettedWall(wall(1, false, corners(1.1), flat)).regions().size(), 1U);
  EXPECT_EQ(WettedWall(wall(1, false, corners(0.9), flat)).regions().size(), 2U);
}

TEST(WettedWall, OneDiscOverAPeriodicCorner) {
  const WettedWall inside(wall(50, true, disc(0.52, 0.5, 0.2), flat));
  const WettedWall corner(wall(50, true, disc(0.98, 0.02, 0.2), flat));
  ASSERT_EQ(corner.regions().size(), 1U);
  EXPECT_NEAR(corner.regions()[0].area, inside.regions()[0].area, 1e-12);
  EXPECT_NEAR(corner.regions()[0].centre[0], 0.98, 1e-12);
  EXPECT_NEAR(corner.regions()[0].centre[1], 0.02, 1e-12);
  EXPECT_EQ(corner.regions()[0].cut, (std::array<int, 2>{0, 0}));
  EXPECT_EQ(corner.region_at({0.05, 0.95}), 0);
  EXPECT_EQ(corner.region_at({0.5, 0.5}), -1);
  EXPECT_EQ(WettedWall(wall(50, false, disc(0.98, 0.02, 0.2), flat)).regions().size(), 4U) << "sides part it";
}

}  // namespace
}  // namespace softwet
