// The automatic box of fine elements around droplets, and the warning about boxes that are too small.
#include "casefile/checks/fine_box.hpp"

#include <gtest/gtest.h>

#include "case/mesh.hpp"
#include "unit/casefile/bad_case.hpp"

namespace softwet {
namespace {

/// A droplet in a box whose other numbers do not matter.
Case droplet_at(double height, FineElements fine = FineElements::automatic) {
  Case c;
  c.domain.size = {2, 1};
  c.domain.elements = {256, 128};
  c.domain.grading.fine = fine;
  c.fluid = Fluid{};
  c.fluid->capillarity = 1.0 / 64;
  c.fluid->temperature = 0.39;
  c.fluid->contact_angle = 75;
  c.substrate = Substrate{};
  c.substrate->thickness = 0.125;
  c.substrate->young = 0.75;
  c.droplets = {{{1.0, height}, 0.15}};
  return c;
}

TEST(FineBox, AnAutomaticOneDoesNotWarnOfItself) {
  for (double height : {0.125, 0.6}) {
    Case c = droplet_at(height);
    choose_fine_box(c);
    EXPECT_LT(c.domain.grading.upper[1], 1) << "it is smaller than the domain";
    EXPECT_EQ(warning_about_fine_box(c), "") << height;
  }
}

TEST(FineBox, ATooSmallOneIsReportedWithItsPosition) {
  for (double height : {0.125, 0.6}) {
    Case c = droplet_at(height);
    choose_fine_box(c);
    c.domain.grading.upper[1] -= 1.5 * c.fluid->capillarity;
    EXPECT_NE(warning_about_fine_box(c).find("along axis 1"), std::string::npos) << height;
  }
}

/// A load that pulls holds its droplet where Poisson's ratio is large, and lets it cross where it is small.
TEST(FineBox, ReachesAsFarAsALoadMayDrawADroplet) {
  for (const double side : {1.0, -1.0}) {
    Case c = droplet_at(0.125);
    const double near = 1 + 0.2 * side, far = 1 + 0.3 * side;
    c.loads = {{{std::min(near, far), 0}, {std::max(near, far), 0.125}, {0.1 * side, 0}}};
    const auto reach = [&](double poisson) {
      Case graded = c;
      graded.substrate->poisson = poisson;
      choose_fine_box(graded);
      return side * ((side > 0 ? graded.domain.grading.upper : graded.domain.grading.lower)[0] - 1);
    };
    const double half = 0.15 * std::sin(75 * M_PI / 180) + 3.0 / 64;
    EXPECT_NEAR(reach(0.45), 0.8 * 0.2 + half, 1e-12);
    EXPECT_NEAR(reach(0.15), 0.3 + half, 1e-12);
  }
}

/// A droplet on the seam of a periodic axis needs a box that reaches around it.
TEST(FineBox, AroundAPeriodicEnd) {
  Case c = droplet_at(0.125, FineElements::box);
  c.boundary.side[0] = {Side::periodic, Side::periodic};
  c.droplets[0].centre[0] = 0;
  c.domain.grading.upper = {0.4, 0.6};
  c.domain.grading.lower = {0, 0};
  EXPECT_NE(warning_about_fine_box(c).find("along axis 0"), std::string::npos);
  c.domain.grading.lower[0] = -0.4;
  EXPECT_EQ(warning_about_fine_box(c), "");
  c.domain.grading.lower[0] = 1.6, c.domain.grading.upper[0] = 2.4;
  EXPECT_EQ(warning_about_fine_box(c), "");
}

/// The box that the warning names holds the droplet, also where the droplet needs all of the axis.
TEST(FineBox, TheWarningNamesOneThatIsLargeEnough) {
  Case c = droplet_at(0.125, FineElements::box);
  c.boundary.side[0] = {Side::periodic, Side::periodic};
  c.droplets[0].centre[0] = 0;
  c.domain.grading.lower = {0, 0};
  c.domain.grading.upper = {0.4, 0.6};
  const std::string what = warning_about_fine_box(c);
  EXPECT_NE(what.find("a larger box, [-0.1918, 0.4"), std::string::npos) << what;  // 0.15 sin 75 degrees and 3/64
  EXPECT_NE(what.find("] along this axis, which may reach around"), std::string::npos) << what;
  c.droplets[0] = {{1.0, 0.5}, 0.98};
  c.domain.grading.lower[0] = 0.5, c.domain.grading.upper[0] = 1.5;
  EXPECT_NE(warning_about_fine_box(c).find("[0, 2] along this axis"), std::string::npos) << warning_about_fine_box(c);
}

/// A film has interfaces at the ends that lie within the domain.
TEST(FineBox, HoldsTheEndsOfFilms) {
  const auto said = [](std::vector<double> lower, std::vector<double> upper, std::vector<double> fine, Side side) {
    Case c = droplet_at(0.125, FineElements::box);
    c.droplets.clear();
    c.boundary.side[0] = {side, side};
    c.films = {{std::move(lower), std::move(upper)}};
    c.domain.grading.lower = {fine[0], 0};
    c.domain.grading.upper = {fine[1], fine[2]};
    return warning_about_fine_box(c);
  };
  for (const Side side : {Side::slip, Side::periodic})
    EXPECT_EQ(said({0, 0.125}, {2, 0.4}, {0.8, 1.2, 0.5}, side), "") << "it has no ends along the wall";
  EXPECT_NE(said({0, 0.125}, {2, 0.4}, {0, 2, 0.41}, Side::slip).find("film[0] lies in [0.125, 0.4] along axis 1"),
            std::string::npos);
  EXPECT_NE(said({0, 0.125}, {1, 0.4}, {0, 1.02, 0.5}, Side::slip).find("end at"), std::string::npos);
  EXPECT_EQ(said({0, 0.125}, {1, 0.4}, {0.9, 1.1, 0.5}, Side::slip), "") << "its left end is a side";
  EXPECT_NE(said({0, 0.125}, {1, 0.4}, {0.9, 1.1, 0.5}, Side::periodic).find("[-0.04688, "), std::string::npos);
}

std::string answer_to(const std::string& left, const std::string& box, const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings{"boundary.left=\"" + left + "\"", "boundary.right=\"" + left + "\"",
                                    "domain.grading.box=" + box};
  settings.insert(settings.end(), more.begin(), more.end());
  return testing_tools::message_of(testing_tools::pull_text(), settings);
}

TEST(FineBox, ReachesAroundPeriodicSidesAlone) {
  using testing_tools::expect_parts;
  EXPECT_EQ(answer_to("periodic", "[[-0.2,0],[0.4,0.4]]"), "(accepted)");
  EXPECT_EQ(answer_to("periodic", "[[0.8,0],[1.4,0.4]]"), "(accepted)");
  expect_parts(answer_to("slip", "[[-0.2,0],[0.4,0.4]]"), {"domain.grading.box", "outside the domain", "[0, 1]"});
  expect_parts(answer_to("periodic", "[[-0.2,0],[0.9,0.4]]"),
               {"domain.grading.box", "longer than the periodic axis 0", "shrink"});
  expect_parts(answer_to("periodic", "[[-1.2,0],[-0.9,0.4]]"),
               {"domain.grading.box", "outside [-1, 2]", "move or shrink"});
  expect_parts(answer_to("periodic", "[[0.2,-0.1],[0.9,0.4]]"), {"domain.grading.box", "outside the domain", "axis 1"});
}

/// Periodic splines of degree 2 need five elements, also of those that are left.
TEST(FineBox, LeavesEnoughElementsOfAPeriodicAxis) {
  testing_tools::expect_parts(
      answer_to("periodic", "[[0.25,0],[0.375,0.4]]", {"domain.elements=[8,64]", "domain.grading.ratio=2"}),
      {"domain.grading.box", "leaves 4 elements along the periodic axis 0", "5 or more", "larger box"});
}

}  // namespace
}  // namespace softwet
