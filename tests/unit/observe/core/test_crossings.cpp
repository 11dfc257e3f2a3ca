// Crossings of a level along a row of samples, all of them or those of a window.
#include "observe/crossings.hpp"

#include <gtest/gtest.h>

#include "observe/section.hpp"
#include "unit/observe/core/quadric.hpp"

namespace softwet::testing_tools {
namespace {

/// The nearest one of all of a row that lead into the droplet on its side.
std::optional<Crossing> nearest_of_all(const std::vector<double>& row, const double* depth, double inside,
                                       int direction) {
  std::optional<Crossing> nearest;
  for (const Crossing& c : crossings(row, depth))
    if (c.direction == direction && direction * (inside - c.x) > 0 &&
        (!nearest || std::abs(c.x - inside) < std::abs(nearest->x - inside)))
      nearest = c;
  return nearest;
}

// Crossings into a droplet at 2.5 and 6.5, out of it at 4.5 and 8.5, sampled at 0, 1, ..., 10.
TEST(Crossings, OfAWindowAreThoseOfTheRow) {
  const std::vector<double> row = equidistant(0, 10, 10), depth{-1, -1, -1, 1, 1, -1, -1, 1, 1, -1, -1};
  for (const double inside : {3.0, 3.25, 4.0, 4.5, 5.5, 7.75, 0.0, 10.0})
    for (const double low : {0.0, 1.5, 2.75, inside})
      for (const double high : {inside, 6.0, 7.0, 9.5, 10.0}) {
        if (low > inside || high < inside) continue;
        const Window window = window_of(row, low, high);
        const double* const within = depth.data() + static_cast<int>(window.x.front());
        for (const int direction : {1, -1}) {
          const auto right = nearest_of_all(row, depth.data(), inside, direction);
          const auto found = nearest_crossing(
              window, within, row, [&] { return depth; }, inside, direction);
          ASSERT_EQ(found.has_value(), right.has_value()) << inside << " " << low << " " << high;
          if (right) {
            EXPECT_EQ(found->x, right->x);
          }
        }
      }
}

// A window beyond the end of its row has one sample, and the row is searched.
TEST(Crossings, AWindowOfOneSampleHasNone) {
  const std::vector<double> row = equidistant(0, 10, 10), depth{-1, -1, -1, 1, 1, -1, -1, 1, 1, -1, -1};
  const Window window = window_of(row, 11, 12);
  ASSERT_EQ(window.x.size(), 1U);
  for (const int direction : {1, -1})
    EXPECT_FALSE(nearest_crossing(window.x, depth.data() + 10, 11, direction).has_value());
  const auto found = nearest_crossing(
      window, depth.data() + 10, row, [&] { return depth; }, 11, 1);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->x, 6.5);
}

TEST(Crossings, AWindowThatHasOneLeavesTheRowAlone) {
  const std::vector<double> row = equidistant(0, 10, 10), depth{-1, -1, -1, 1, 1, -1, -1, 1, 1, -1, -1};
  const Window window = window_of(row, 2.25, 4.75);
  EXPECT_EQ(window.x, (std::vector<double>{2, 3, 4, 5}));
  const auto never = [&] {
    ADD_FAILURE() << "the whole row was sampled";
    return depth;
  };
  EXPECT_EQ(nearest_crossing(window, depth.data() + 2, row, never, 3.5, 1)->x, 2.5);
  EXPECT_EQ(nearest_crossing(window, depth.data() + 2, row, never, 3.5, -1)->x, 4.5);
}

}  // namespace
}  // namespace softwet::testing_tools
