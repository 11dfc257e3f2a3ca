// Crossings of a level along a row of samples: all of them, or the crossings of a window.
#include "observe/crossings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

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

TEST(MeanOverElements, LeavesParabolasAsTheyAre) {
  const auto parabola = [](std::vector<double> x) {
    for (double& value : x) value = 3 - 2 * value + 5 * value * value;
    return x;
  };
  for (const double element : {0.1, 0.03}) {
    EXPECT_NEAR(MeanOverElements()(parabola, 0.7, element), parabola({0.7})[0], 1e-14);
  }
}

/// The quadratic spline with elements of length 1 that is nearest to a function in the mean square. The function is
/// constant far away.
class NearestSpline {
 public:
  template <class Function>
  explicit NearestSpline(const Function& f) {
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(2 * far + 2, 2 * far + 2);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * far + 2);
    constexpr int points = 40;  // of the midpoint rule in an element
    for (int e = 0; e < 2 * far; ++e)
      for (int k = 0; k < points; ++k) {
        const double s = (k + 0.5) / points;
        const Eigen::Vector3d at = functions(s);
        right.segment<3>(e) += at * f(e - far + s) / points;
        products.block<3, 3>(e, e) += at * at.transpose() / points;
      }
    control_ = products.ldlt().solve(right);
  }
  double operator()(double x) const {
    const double from = std::floor(x);
    return functions(x - from).dot(control_.segment<3>(static_cast<int>(from) + far));
  }

 private:
  static constexpr int far = 16;
  static Eigen::Vector3d functions(double s) { return {0.5 * (1 - s) * (1 - s), 0.5 + s - s * s, 0.5 * s * s}; }
  Eigen::VectorXd control_;
};

/// Distances between a zero of a spline and the zero of the profile of an interface, two elements to the capillarity:
/// the largest distances of the spline itself and of its mean, in elements, over all places of the interface in an
/// element.
std::pair<double, double> errors_of_zeros() {
  double of_spline = 0, of_mean = 0;
  for (int k = 0; k < 16; ++k) {
    const double place = k / 16.0;
    const NearestSpline spline([place](double x) { return std::tanh((x - place) / 2); });
    const auto values = [&](std::vector<double> x) {
      for (double& value : x) value = spline(value);
      return x;
    };
    const auto mean = [&](double x) { return MeanOverElements()(values, x, 1.0); };
    of_spline = std::max(of_spline, std::abs(*zero_between(spline, place - 0.5, place + 0.5, 1) - place));
    of_mean = std::max(of_mean, std::abs(*zero_between(mean, place - 0.5, place + 0.5, 1) - place));
  }
  return {of_spline, of_mean};
}

// The zero of the spline swings by 0.54 % of an element, which is 2.4 % of the speed of an interface that moves.
TEST(MeanOverElements, FollowsAnInterfaceThatTheSplineSwingsAbout) {
  const auto [of_spline, of_mean] = errors_of_zeros();
  EXPECT_NEAR(of_spline, 0.0054, 0.0003);
  EXPECT_LT(of_mean, 0.15 * of_spline);
}

}  // namespace
}  // namespace softwet::testing_tools
