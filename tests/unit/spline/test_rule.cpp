// Tables of element rules against the axis they come from.
#include "spline/rule.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace softwet {
namespace {

template <class V>
auto host(const V& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

TEST(AxisRule, TablesMatchTheAxis) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded, 3);
  const AxisRule rule = gauss_rule(axis, 2, 6, 3);
  EXPECT_EQ(rule.elements, 4);
  EXPECT_EQ(rule.points, 3);
  const auto v = host(rule.value), s = host(rule.slope);
  const auto w = host(rule.weight), x = host(rule.position);
  const auto f = host(rule.first);
  double length = 0, cube = 0;
  for (int e = 0; e < 4; ++e) {
    EXPECT_EQ(f(e), axis.span(2 + e));
    for (int q = 0; q < 3; ++q) {
      EXPECT_GT(x(q, e), axis.lower(2 + e));
      EXPECT_LT(x(q, e), axis.lower(3 + e));
      length += w(q, e);
      cube += w(q, e) * std::pow(x(q, e), 3);
      const auto value = axis.values(2 + e, x(q, e)), slope = axis.slopes(2 + e, x(q, e));
      for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(v(q, a, e), value[a]);
        EXPECT_EQ(s(q, a, e), slope[a]);
      }
    }
  }
  const double a = axis.lower(2), b = axis.lower(6);
  EXPECT_NEAR(length, b - a, 1e-15);
  EXPECT_NEAR(cube, (b * b * b * b - a * a * a * a) / 4, 1e-15);
}

// Each point has the means over its element, of functions and slopes, and they share its length.
TEST(AxisRule, MeansOfElements) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded, 3);
  const AxisRule rule = mean_rule(axis, 2, 6, 3), gauss = gauss_rule(axis, 2, 6, 4);
  EXPECT_EQ(rule.elements, 4);
  EXPECT_EQ(rule.points, 3);
  const auto w = host(rule.weight), gauss_weight = host(gauss.weight);
  const auto v = host(rule.value), s = host(rule.slope), gauss_value = host(gauss.value);
  for (int e = 0; e < 4; ++e) {
    const double length = axis.size(2 + e);
    EXPECT_NEAR(w(0, e) + w(1, e) + w(2, e), length, 1e-15);
    const auto low = axis.values(2 + e, axis.lower(2 + e)), high = axis.values(2 + e, axis.lower(3 + e));
    for (int a = 0; a < 3; ++a) {
      double integral = 0;
      for (int q = 0; q < 4; ++q) integral += gauss_weight(q, e) * gauss_value(q, a, e);
      for (int q = 0; q < 3; ++q) {
        EXPECT_NEAR(v(q, a, e), integral / length, 1e-14);
        EXPECT_NEAR(s(q, a, e), (high[a] - low[a]) / length, 1e-12);
      }
    }
  }
}

// A pack may read past the last element: the tables repeat it there, without weight.
TEST(AxisRule, PaddingCarriesNoWeight) {
  const Axis axis(0.9, 7, 2);
  const AxisRule rule = gauss_rule(axis, 0, 7, 3);
  const auto w = host(rule.weight), x = host(rule.position);
  const auto v = host(rule.value);
  ASSERT_EQ(w.extent(1), 7u + lane_padding);
  for (int e = 7; e < 7 + lane_padding; ++e)
    for (int q = 0; q < 3; ++q) {
      EXPECT_EQ(w(q, e), 0);
      EXPECT_EQ(x(q, e), x(q, 6));
      EXPECT_EQ(v(q, 1, e), v(q, 1, 6));
    }
}

TEST(AxisRule, LowFaceIsTheTrace) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded, 3);
  const AxisRule rule = low_face_rule(axis, 3);
  const auto v = host(rule.value);
  const auto w = host(rule.weight), x = host(rule.position);
  EXPECT_EQ(rule.points, 1);
  EXPECT_EQ(w(0, 0), 1);
  EXPECT_DOUBLE_EQ(x(0, 0), axis.lower(3));
  EXPECT_NEAR(v(0, 0, 0), 1, 1e-15);
  EXPECT_NEAR(v(0, 1, 0), 0, 1e-15);
  EXPECT_NEAR(v(0, 2, 0), 0, 1e-15);
}

TEST(AxisRule, RestrictionKeepsOneFunction) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded, 3);
  const AxisRule rule = gauss_rule(axis, 3, 4, 3), only = restricted_to(rule, 0);
  const auto v = host(rule.value), r = host(only.value), rs = host(only.slope), s = host(rule.slope);
  for (int q = 0; q < 3; ++q)
    for (int a = 0; a < 3; ++a) {
      EXPECT_EQ(r(q, a, 0), a == 0 ? v(q, a, 0) : 0);
      EXPECT_EQ(rs(q, a, 0), a == 0 ? s(q, a, 0) : 0);
    }
}

// The force of a uniform stress on a function, along r and around the axis, is what leaves or enters at the ends of the
// axis: nothing inside. An upright stress pulls as a pressure on the wall does: by the integral of the function times r.
TEST(AxisRule, MeansAroundAnAxisHaveTheResultantsOfAUniformStress) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded);
  const AxisRule rule = mean_rule(axis, 0, 7, 3, MeanWeight::radius), gauss = gauss_rule(axis, 0, 7, 3);
  const auto v = host(rule.value), s = host(rule.slope), n = host(gauss.value);
  const auto w = host(rule.weight), x = host(rule.position), length = host(gauss.weight), r = host(gauss.position);
  std::vector<double> force(9), upright(9), pressure(9);
  for (int e = 0; e < 7; ++e) {
    double divergence = 0;  // of v_r = r
    for (int a = 0; a < 3; ++a) {
      divergence += (s(0, a, e) + v(0, a, e) / x(0, e)) * axis.greville(e + a);
      for (int q = 0; q < 3; ++q) {
        force[e + a] += w(q, e) * (x(q, e) * s(q, a, e) + v(q, a, e));
        upright[e + a] += w(q, e) * x(q, e) * v(q, a, e);
        pressure[e + a] += length(q, e) * r(q, e) * n(q, a, e);
      }
    }
    EXPECT_NEAR(divergence, 2, 1e-13);
  }
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(upright[i], pressure[i], 1e-15) << i;
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(force[i], 0, 1e-15) << i;
  EXPECT_NEAR(force[8], 0.9, 1e-14);
}

}  // namespace
}  // namespace softwet
