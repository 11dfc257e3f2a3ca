// Ends of graded elements.
#include "case/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

Case graded(double low, double high, double coarsest = 4, double ratio = 1.3) {
  Case c;
  c.domain.size = {1.0, 0.5};
  c.domain.elements = {128, 64};
  c.domain.grading = {FineElements::box, {low, 0.1}, {high, 0.27}, coarsest, ratio};
  return c;
}

TEST(Mesh, FineInTheBoxAndGrowingBesideIt) {
  for (const double coarsest : {1.0, 2.5, 4.0, 16.0})
    for (const double ratio : {1.05, 1.3, 2.0})
      for (const auto& [low, high] : {std::pair{0.281, 0.873}, {0.0, 0.3}, {0.4, 1.0}, {0.01, 0.5}}) {
        const Case c = graded(low, high, coarsest, ratio);
        const double h = fine_length(c, 0);
        const std::vector<double> x = graded_breaks(c, 0);
        if (x.empty()) {
          EXPECT_GT(high - low, 0.2) << "a small box is worth grading unless nothing may grow";
          EXPECT_EQ(elements_along(c, 0), 128);
          continue;
        }
        EXPECT_EQ(x.front(), 0);
        EXPECT_EQ(x.back(), 1);
        EXPECT_LE(elements_along(c, 0), 0.95 * 128);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
          const double length = x[i + 1] - x[i];
          EXPECT_GT(length, h * (1 - 1e-9));
          EXPECT_LT(length, coarsest * h * (1 + 1e-9));
          if (x[i] >= low && x[i + 1] <= high) {
            EXPECT_NEAR(length, h, 1e-12) << "from " << x[i];
          }
          if (i == 0) continue;
          EXPECT_LT(std::abs(std::log(length / (x[i] - x[i - 1]))), std::log(ratio) + 1e-9);
        }
      }
}

Case around(int low, int high, int all, double coarsest, double ratio) {
  Case c = graded(static_cast<double>(low) / all, static_cast<double>(high) / all, coarsest, ratio);
  c.domain.elements[0] = all;
  c.boundary.side[0] = {Side::periodic, Side::periodic};
  return c;
}

/// The last element is the neighbour of the first, wherever the box lies: inside, at an end, or around it.
TEST(Mesh, AroundAPeriodicAxisNeighboursKeepTheRatio) {
  int graded_axes = 0;
  for (const int all : {31, 64})
    for (const double ratio : {1.05, 1.3, 2.0})
      for (const double coarsest : {1.5, 4.0, 16.0})
        for (int low = -all; low < all; ++low)
          for (const int wide : {1, 2, 3, 7, all / 4, all / 2}) {
            const Case c = around(low, low + wide, all, coarsest, ratio);
            const std::vector<double> x = graded_breaks(c, 0);
            if (x.empty()) continue;
            ++graded_axes;
            ASSERT_EQ(x.front(), 0);
            ASSERT_EQ(x.back(), 1);
            double before = x.back() - x[x.size() - 2];
            for (std::size_t i = 0; i + 1 < x.size(); ++i) {
              const double length = x[i + 1] - x[i];
              ASSERT_LT(std::abs(std::log(length / before)), std::log(ratio) + 1e-9)
                  << all << " " << low << " " << wide;
              ASSERT_GT(length * all, 1 - 1e-9);
              ASSERT_LT(length * all, coarsest + 1e-9);
              before = length;
            }
          }
  EXPECT_GT(graded_axes, 1000);
}

/// A correct mesh stays as it was: elements that have grown to the longest ones on both sides meet at the seam.
TEST(Mesh, APeriodicAxisWhoseEndsAreAlikeIsThatBetweenWalls) {
  Case c = around(54, 74, 128, 2, 1.3);
  const std::vector<double> ring = graded_breaks(c, 0);
  c.boundary.side[0] = {Side::slip, Side::slip};
  EXPECT_EQ(ring, graded_breaks(c, 0));
}

/// A box at an end has neighbours across it, and is the box around the end that is as far away from it on both sides.
TEST(Mesh, ABoxAtAPeriodicEndIsFineUpToIt) {
  const FinePart at_end = fine_part(around(0, 39, 128, 4, 1.3), 0);
  EXPECT_EQ(at_end.low, 0);
  EXPECT_EQ(at_end.high, 39.0 / 128);
  const FinePart across = fine_part(around(-10, 39, 128, 4, 1.3), 0);
  EXPECT_EQ(across.low, 118.0 / 128);
  EXPECT_EQ(across.high, 1 + 39.0 / 128);
  EXPECT_EQ(graded_breaks(around(-10, 39, 128, 4, 1.3), 0), graded_breaks(around(118, 167, 128, 4, 1.3), 0));
}

TEST(Mesh, FineElementsLieOnLinesOfTheEqualMesh) {
  const Case c = graded(0.281, 0.873);
  const FinePart fine = fine_part(c, 0);
  EXPECT_EQ(fine.low, 35.0 / 128);
  EXPECT_EQ(fine.high, 112.0 / 128);
  EXPECT_TRUE(std::isinf(fine_part(graded(0, 0.3), 0).low));
  EXPECT_EQ(fine_part(graded(0, 0.3), 0).high, 39.0 / 128);
}

TEST(Mesh, TheWallIsAnEndOfElements) {
  Case c = graded(0.3, 0.8);
  c.substrate.emplace();
  c.substrate->thickness = 0.125;
  const std::vector<double> y = graded_breaks(c, 1);
  EXPECT_EQ(y[solid_elements(c)], 0.125);
  EXPECT_LT(solid_elements(c), 16);
  c.domain.grading = {};
  EXPECT_EQ(solid_elements(c), 16);
}

TEST(Mesh, WithoutABoxElementsAreEqual) {
  Case c = graded(0.3, 0.8);
  c.domain.grading.lower.clear();
  c.domain.grading.upper.clear();
  EXPECT_TRUE(graded_breaks(c, 0).empty());
  EXPECT_EQ(elements_along(c, 1), 64);
  EXPECT_EQ(share_of_elements(c), 1);
}

}  // namespace
}  // namespace softwet
