// Droplets as wholes, painted on a small grid: each thing that happens to them is said once, and nothing else is.
#include "observe/host/droplet_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "casefile/case_file.hpp"

namespace softwet {
namespace {

using Said = std::vector<std::string>;

/// A plane whose rows are given from the top down, # inside; points are 1 apart and the wall is the lowest row.
PhaseSamples plane(const std::vector<std::string>& rows, bool periodic_x = false) {
  PhaseSamples samples;
  samples.points = {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1};
  samples.periodic[0] = periodic_x;
  samples.step = {1, 1, 1};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (char c : *row) samples.depth.push_back(c == '#' ? 1 : -1);
  return samples;
}

std::vector<Body> bodies_at(const std::vector<std::array<double, 3>>& places) {
  std::vector<Body> bodies;
  for (const auto& place : places) bodies.emplace_back().place = place;
  return bodies;
}

const Said one{"the droplet"}, two{"droplet 1", "droplet 2"};

TEST(DropletWatch, ADropletThatStaysIsNoEvent) {
  std::vector<Body> bodies = bodies_at({{3, 0, 0}});
  for (int row = 0; row < 3; ++row) EXPECT_EQ(follow(bodies, plane({".......", "..###..", ".#####."}), one), Said{});
  EXPECT_TRUE(bodies[0].on_wall);
  EXPECT_EQ(bodies[0].place[0], 3);
}

TEST(DropletWatch, ADropletVanishesOnce) {
  std::vector<Body> bodies = bodies_at({{3, 0, 0}});
  follow(bodies, plane({".......", "..###.."}), one);
  EXPECT_EQ(follow(bodies, plane({".......", "......."}), one),
            Said{"the droplet vanished: no liquid is left, and the run goes on with vapour alone"});
  EXPECT_EQ(follow(bodies, plane({".......", "......."}), one), Said{});
  EXPECT_EQ(follow(bodies, plane({".......", "..###.."}), one), Said{}) << "what condenses later is another droplet";
}

TEST(DropletWatch, OneOfTwoVanishes) {
  std::vector<Body> bodies = bodies_at({{1, 0, 0}, {7, 0, 0}});
  follow(bodies, plane({".........", "###...###"}), two);
  EXPECT_EQ(follow(bodies, plane({".........", "###......"}), two), Said{"droplet 2 vanished"});
}

TEST(DropletWatch, ABubbleLeavesLiquidBehind) {
  std::vector<Body> bodies = bodies_at({{3, 1, 0}});
  PhaseSamples samples = plane({".......", "...#...", "......."});
  samples.bubbles = true;
  follow(bodies, samples, {"the bubble"});
  samples.depth.assign(samples.depth.size(), -1);
  EXPECT_EQ(follow(bodies, samples, {"the bubble"}),
            Said{"the bubble vanished: no vapour is left, and the run goes on with liquid alone"});
}

TEST(DropletWatch, SidesReachedLaterAreEventsAndThoseOfTheStartAreNot) {
  std::vector<Body> bodies = bodies_at({{0, 0, 0}});  // half a droplet on its plane of symmetry
  EXPECT_EQ(follow(bodies, plane({".....", "##..."}), one), Said{});
  EXPECT_EQ(follow(bodies, plane({".....", "#####"}), one), Said{"the droplet reached the right side"});
  follow(bodies, plane({".....", "##..."}), one);
  EXPECT_EQ(follow(bodies, plane({"##...", "#####"}), one), Said{"the droplet reached the top"})
      << "a side is said once";
}

TEST(DropletWatch, AcrossAPeriodicSideThereIsNoSide) {
  std::vector<Body> bodies = bodies_at({{0, 0, 0}});
  follow(bodies, plane({".......", "##.....", "##....."}, true), one);
  EXPECT_EQ(follow(bodies, plane({".......", "##....#", "##....#"}, true), one), Said{});
  EXPECT_EQ(follow(bodies, plane({".......", "#....##", "#....##"}, true), one), Said{}) << "it is one droplet";
}

/// The fine elements may reach around a periodic side, from 8 to 12 of 10.
TEST(DropletWatch, FineElementsAroundAPeriodicSide) {
  const auto fine_around = [](std::vector<std::string> rows) {
    PhaseSamples samples = plane(rows, true);
    samples.low[0] = 8, samples.high[0] = 12;
    return samples;
  };
  std::vector<Body> bodies = bodies_at({{0, 0, 0}});
  EXPECT_EQ(follow(bodies, fine_around({"..........", "##......##"}), one), Said{});
  EXPECT_EQ(follow(bodies, fine_around({"..........", "###......#"}), one), Said{});
  const Said said = follow(bodies, fine_around({"..........", "####......"}), one);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("end of the fine elements, towards the right side"), std::string::npos) << said[0];
  const Said left = follow(bodies, fine_around({"..........", "##.....###"}), one);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_NE(left[0].find("towards the left side"), std::string::npos) << left[0];
}

TEST(DropletWatch, TheWallIsLeftAndReached) {
  std::vector<Body> bodies = bodies_at({{2, 0, 0}, {7, 2, 0}});
  follow(bodies, plane({"..........", "......###.", ".###......", ".###......"}), two);
  EXPECT_EQ(follow(bodies, plane({"..........", ".###......", ".###..###.", "......###."}), two),
            (Said{"droplet 1 lost its contact line: it no longer touches the wall", "droplet 2 reached the wall"}));
}

TEST(DropletWatch, TwoMergeAndTheFirstGoesOn) {
  std::vector<Body> bodies = bodies_at({{1, 0, 0}, {7, 0, 0}});
  follow(bodies, plane({".........", ".##...##."}), two);
  EXPECT_EQ(follow(bodies, plane({".........", ".#######."}), two), Said{"droplet 1 and droplet 2 merged"});
  EXPECT_EQ(follow(bodies, plane({".........", "..#####.."}), two), Said{});
  EXPECT_EQ(follow(bodies, plane({".........", "........."}), two).size(), 1U) << "one droplet is left to vanish";
}

TEST(DropletWatch, DropletsThatOverlapAtTheStartAreOne) {
  std::vector<Body> bodies = bodies_at({{2, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(follow(bodies, plane({".......", "..####."}), two), Said{"droplet 1 and droplet 2 are one from the start"});
  EXPECT_EQ(follow(bodies, plane({".......", "..####."}), two), Said{});
}

TEST(DropletWatch, ADropletThatHasMovedFarIsStillItself) {
  std::vector<Body> bodies = bodies_at({{1, 0, 0}, {5, 0, 0}});
  follow(bodies, plane({"............", "###..##....."}), two);
  EXPECT_EQ(follow(bodies, plane({"............", "###......##."}), two), Said{});
  EXPECT_GE(bodies[1].place[0], 9);
}

TEST(DropletWatch, InSpaceAllSidesHaveNames) {
  PhaseSamples box;
  box.dimension = 3;
  box.points = {5, 5, 5};
  box.step = {1, 1, 1};
  box.depth.assign(125, -1);
  box.depth[2 + 5 * 2 + 25 * 2] = 1;
  std::vector<Body> bodies = bodies_at({{2, 2, 2}});
  EXPECT_EQ(follow(bodies, box, one), Said{});
  box.depth.assign(125, 1);
  EXPECT_EQ(follow(bodies, box, one), (Said{"the droplet reached the left side", "the droplet reached the right side",
                                            "the droplet reached the front side", "the droplet reached the back side",
                                            "the droplet reached the wall", "the droplet reached the top"}));
}

TEST(DropletWatch, ReportsHowFarDropletsMove) {
  std::vector<Body> bodies = bodies_at({{1, 0, 0}, {7, 0, 0}, {11, 0, 0}});
  const Said three{"droplet 1", "droplet 2", "droplet 3"};
  PhaseSamples before = plane({"............", ".##...##...#"}), after = plane({".##.........", ".##....##..."});
  before.depth[1] = 3;  // deeper: the centre is at 1.25
  follow(bodies, before, three);
  const std::vector<Centre> from = centres_of(bodies, before);
  EXPECT_NEAR((*from[0])[0], 1.25, 1e-12);
  follow(bodies, after, three);
  const auto moved = distances(from, centres_of(bodies, after), after);
  EXPECT_NEAR(*moved[0], std::hypot(0.25, 0.5), 1e-12) << "from (1.25, 0) to (1.5, 0.5)";
  EXPECT_NEAR(*moved[1], 1, 1e-12);
  EXPECT_FALSE(moved[2]) << "it is gone";
}

// What spreads along r is the same body all round the axis; a ring farther out weighs more.
TEST(DropletWatch, OnAnAxisOfSymmetryADropletMovesAlongItAlone) {
  std::vector<Body> bodies = bodies_at({{0, 0, 0}});
  PhaseSamples before = plane({".....", "##..."}), after = plane({"##...", "####."});
  before.rings = after.rings = {0, 1, 2, 3, 4};
  follow(bodies, before, one);
  const std::vector<Centre> from = centres_of(bodies, before);
  follow(bodies, after, one);
  EXPECT_NEAR(*distances(from, centres_of(bodies, after), after)[0], 1.0 / 7, 1e-12)
      << "weights 0, 1, 2, 3 below, 0, 1 above";
}

TEST(DropletWatch, MovesTheShorterWayRound) {
  std::vector<Body> bodies = bodies_at({{0, 0, 0}});
  const PhaseSamples before = plane({"..........", "##.......#"}, true),
                     after = plane({"..........", "#.......##"}, true);
  follow(bodies, before, one);
  const std::vector<Centre> from = centres_of(bodies, before);
  follow(bodies, after, one);
  EXPECT_NEAR(*distances(from, centres_of(bodies, after), after)[0], 1, 1e-12);
  const PhaseSamples film = plane({"..........", "##########"}, true);
  follow(bodies, film, one);
  EXPECT_NEAR(*distances(centres_of(bodies, film), centres_of(bodies, film), film)[0], 0, 1e-12);
}

Case scene(const std::string& more) {
  return parse_case(
      "name='b'\ntime.end=1\ndomain={size=[1,0.5],elements=[8,8]}\n[fluid]\nviscosity=1\n"
      "capillarity=0.1\ntemperature=0.5\n" +
          more,
      "box.toml");
}

TEST(Bodies, AreTheDropletsAndFilmsOfACase) {
  const std::string droplet = "[[droplet]]\ncentre=[0.4,0]\nradius=0.1\n";
  EXPECT_EQ(body_names(scene(droplet)), one);
  EXPECT_EQ(body_names(scene(droplet + droplet)), two);
  EXPECT_EQ(body_names(scene("ambient='liquid'\n" + droplet)), Said{"the bubble"});
  const Case with_film = scene(droplet + "[[film]]\nbox=[[0.5,0.25],[1.0,0.5]]\n");
  EXPECT_EQ(body_names(with_film), (Said{"the droplet", "the film"}));
  EXPECT_EQ(bodies_of(with_film)[0].place, (std::array<double, 3>{0.4, 0, 0}));
  EXPECT_EQ(bodies_of(with_film)[1].place, (std::array<double, 3>{0.75, 0.375, 0}));
}

}  // namespace
}  // namespace softwet
