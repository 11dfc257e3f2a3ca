// Evaluation on tensor grids against direct sums over basis functions.
#include "spline/evaluate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

TEST(Evaluate, GridIn2DWithShiftAndDerivatives) {
  const Axis x(0.9, 7, 2), y(0.6, 5, 2, AxisKind::bounded, 2);
  const int wall = y.span(2), rows = y.functions() - wall;
  std::vector<double> box(x.functions() * rows);
  for (std::size_t i = 0; i < box.size(); ++i) box[i] = std::sin(1 + 3.7 * i);
  const std::vector<double> px{0.0, 0.11, 0.5, 0.9}, py{0.24, 0.3, 0.6};
  for (int derivative = -1; derivative < 2; ++derivative) {
    const auto of = [&](int d) { return d == derivative ? Sampled::slopes : Sampled::values; };
    const std::array<AxisSamples, 2> at{sample_axis(x, px, of(0)), sample_axis(y, py, of(1), wall, 2)};
    const std::vector<double> found = evaluate_grid<2>(box.data(), {x.functions(), rows}, at);
    ASSERT_EQ(found.size(), 12u);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) {
        const int ex = x.element_at(px[i]), ey = std::max(2, y.element_at(py[j]));
        const auto bx = derivative == 0 ? x.slopes(ex, px[i]) : x.values(ex, px[i]);
        const auto by = derivative == 1 ? y.slopes(ey, py[j]) : y.values(ey, py[j]);
        double sum = 0;
        for (int b = 0; b < 3; ++b)
          for (int a = 0; a < 3; ++a)
            sum += bx[a] * by[b] * box[(y.span(ey) + b - wall) * x.functions() + x.span(ex) + a];
        EXPECT_NEAR(found[j * 4 + i], sum, 1e-12);
      }
  }
}

// Control values at Greville points of a linear function give it back everywhere, and its slopes.
TEST(Evaluate, LinearFunctionIn3D) {
  const Axis x(0.9, 4, 2), y(0.6, 3, 2), z(0.5, 5, 2, AxisKind::bounded, 2);
  std::vector<double> box;
  for (int k = 0; k < z.functions(); ++k)
    for (int j = 0; j < y.functions(); ++j)
      for (int i = 0; i < x.functions(); ++i)
        box.push_back(2 + 3 * x.greville(i) - 5 * y.greville(j) + 7 * z.greville(k));
  const std::vector<double> px{0.0, 0.33, 0.9}, py{0.1, 0.6}, pz{0.0, 0.2, 0.21, 0.5};
  const std::array<AxisSamples, 3> at{sample_axis(x, px), sample_axis(y, py), sample_axis(z, pz)};
  const std::array<int, 3> extent{x.functions(), y.functions(), z.functions()};
  const double slope[3] = {3, -5, 7};
  const auto value = evaluate_grid<3>(box.data(), extent, at);
  for (int k = 0, n = 0; k < 4; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i, ++n) EXPECT_NEAR(value[n], 2 + 3 * px[i] - 5 * py[j] + 7 * pz[k], 1e-13);
  for (int d = 0; d < 3; ++d) {
    std::array<AxisSamples, 3> along = at;
    const Axis& axis = d == 0 ? x : d == 1 ? y : z;
    along[d] = sample_axis(axis, d == 0 ? px : d == 1 ? py : pz, Sampled::slopes);
    for (double g : evaluate_grid<3>(box.data(), extent, along)) EXPECT_NEAR(g, slope[d], 1e-11);
  }
}

TEST(Evaluate, TraceOnTheKinkFromEitherSide) {
  const Axis z(0.5, 5, 2, AxisKind::bounded, 2);
  EXPECT_EQ(sample_axis(z, {0.2}, Sampled::values, 0, 2).first[0], z.span(2));
  EXPECT_EQ(sample_axis(z, {0.2}, Sampled::values, 0, 0, 2).first[0], z.span(1));
}

}  // namespace
}  // namespace softwet
