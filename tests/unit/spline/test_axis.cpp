// B-splines of one axis: partition of unity, smoothness, linear precision, integrals; Gauss rules.
#include "spline/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

/// A spline with given control values and its slope, taken from a chosen element.
struct Spline {
  const Axis& axis;
  std::vector<double> control;
  double value(int e, double x) const { return sum(axis.values(e, x), e); }
  double slope(int e, double x) const { return sum(axis.slopes(e, x), e); }
  double sum(const std::vector<double>& b, int e) const {
    double s = 0;
    for (std::size_t a = 0; a < b.size(); ++a) s += b[a] * control[axis.span(e) + a];
    return s;
  }
};

std::vector<double> wild(int n) {
  std::vector<double> c(n);
  for (int i = 0; i < n; ++i) c[i] = std::sin(1 + 7.3 * i * i);
  return c;
}

/// Ends of elements whose lengths follow no rule.
std::vector<double> uneven(int elements) {
  std::vector<double> breaks{0};
  for (int e = 0; e < elements; ++e) breaks.push_back(breaks.back() + 0.1 + 0.07 * std::sin(3.1 * e * e));
  return breaks;
}

std::vector<Axis> axes() {
  return {Axis(uneven(7), 2),
          Axis(uneven(7), 2, AxisKind::bounded, 3),
          Axis(uneven(8), 2, AxisKind::periodic),
          Axis(uneven(9), 3, AxisKind::bounded, 4),
          Axis(uneven(9), 3, AxisKind::periodic),
          Axis(0.9, 7, 2),
          Axis(0.9, 7, 2, AxisKind::bounded, 3, 1),
          Axis(0.9, 7, 2, AxisKind::bounded, 3),
          Axis(0.9, 7, 2, AxisKind::periodic),
          Axis(1.3, 5, 1, AxisKind::bounded, 2),
          Axis(1.3, 6, 3, AxisKind::bounded, 2),
          Axis(1.3, 6, 3, AxisKind::periodic)};
}

TEST(Axis, Counts) {
  EXPECT_EQ(Axis(1, 8, 2).functions(), 10);
  EXPECT_EQ(Axis(1, 8, 2, AxisKind::bounded, 3).functions(), 11);
  EXPECT_EQ(Axis(1, 8, 3, AxisKind::bounded, 3).functions(), 13);
  const Axis p(1, 8, 2, AxisKind::periodic);
  EXPECT_EQ(p.functions(), 10);
  EXPECT_EQ(p.owned(), 8);
  const Axis k(1, 8, 2, AxisKind::bounded, 3);
  EXPECT_EQ(k.span(2), 2);
  EXPECT_EQ(k.span(3), 4) << "the elements beside the kink share one function";
  const Axis joined(1, 8, 3, AxisKind::bounded, 5, 2);
  EXPECT_EQ(joined.functions(), 15);
  EXPECT_EQ(joined.span(2), 4);
  EXPECT_EQ(joined.span(5), 9);
}

TEST(Axis, PartitionOfUnityAndSlope) {
  for (const Axis& axis : axes())
    for (int e = 0; e < axis.elements(); ++e)
      for (double t = 0; t <= 1; t += 0.125) {
        const double x = axis.lower(e) + t * axis.size(e);
        double one = 0, zero = 0;
        for (double v : axis.values(e, x)) {
          one += v;
          EXPECT_GE(v, -1e-15);
        }
        for (double v : axis.slopes(e, x)) zero += v;
        EXPECT_NEAR(one, 1, 1e-14);
        EXPECT_NEAR(zero, 0, 1e-12);
      }
}

TEST(Axis, SlopeAgainstDifferences) {
  for (const Axis& axis : axes()) {
    const Spline s{axis, wild(axis.functions())};
    const double e = 1e-5;
    for (int n = 0; n < axis.elements(); ++n)
      for (const double t : {0.1, 0.5, 0.9}) {
        const double x = axis.lower(n) + t * axis.size(n);
        EXPECT_NEAR(s.slope(n, x), (s.value(n, x + e) - s.value(n, x - e)) / (2 * e), axis.degree() < 3 ? 1e-9 : 1e-5);
      }
  }
}

TEST(Axis, SmoothInsideContinuousAtTheKink) {
  for (const Axis& axis :
       {Axis(0.9, 7, 2), Axis(0.9, 7, 2, AxisKind::bounded, 3), Axis(0.9, 7, 2, AxisKind::bounded, 5, 2),
        Axis(0.9, 7, 2, AxisKind::bounded, 0, 4), Axis(uneven(7), 2), Axis(uneven(7), 2, AxisKind::bounded, 3),
        Axis(uneven(7), 2, AxisKind::bounded, 4, 2)}) {
    const Spline s{axis, wild(axis.functions())};
    for (int e = 1; e < 7; ++e) {
      const double x = axis.lower(e);
      EXPECT_NEAR(s.value(e, x), s.value(e - 1, x), 1e-14);
      if (e == axis.kink() || e == axis.joint()) {
        EXPECT_GT(std::abs(s.slope(e, x) - s.slope(e - 1, x)), 0.1);
        EXPECT_NEAR(s.value(e, x), s.control[axis.span(e)], 1e-14) << "the control value is the value there";
      } else {
        EXPECT_NEAR(s.slope(e, x), s.slope(e - 1, x), 1e-12);
      }
    }
  }
}

TEST(Axis, EndsInterpolate) {
  const Axis axis(0.9, 7, 2, AxisKind::bounded, 3);
  const Spline s{axis, wild(axis.functions())};
  EXPECT_NEAR(s.value(0, 0), s.control.front(), 1e-15);
  EXPECT_NEAR(s.value(6, 0.9), s.control.back(), 1e-14);
}

TEST(Axis, GrevillePointsReproduceTheCoordinate) {
  for (const Axis& axis : axes()) {
    Spline s{axis, {}};
    for (int i = 0; i < axis.functions(); ++i) s.control.push_back(axis.greville(i));
    for (int e = 0; e < axis.elements(); ++e)
      for (const double t : {0.0, 0.3, 1.0}) {
        const double x = axis.lower(e) + t * axis.size(e);
        EXPECT_NEAR(s.value(e, x), x, 1e-14);
        EXPECT_NEAR(s.slope(e, x), 1, 1e-12);
      }
  }
}

TEST(Axis, PeriodicWraps) {
  const Axis axis(0.9, 7, 2, AxisKind::periodic);
  Spline s{axis, wild(axis.functions())};
  for (int g = axis.owned(); g < axis.functions(); ++g) s.control[g] = s.control[g - axis.owned()];
  EXPECT_NEAR(s.value(0, 0), s.value(6, 0.9), 1e-14);
  EXPECT_NEAR(s.slope(0, 0), s.slope(6, 0.9), 1e-12);
  EXPECT_NEAR(axis.greville(axis.owned()), axis.greville(0) + 0.9, 1e-14);
}

TEST(Axis, GradedPeriodicWraps) {
  const Axis axis(uneven(9), 3, AxisKind::periodic);
  Spline s{axis, wild(axis.functions())};
  for (int g = axis.owned(); g < axis.functions(); ++g) s.control[g] = s.control[g - axis.owned()];
  EXPECT_NEAR(s.value(0, 0), s.value(8, axis.length()), 1e-14);
  EXPECT_NEAR(s.slope(0, 0), s.slope(8, axis.length()), 1e-11);
  EXPECT_NEAR(axis.greville(axis.owned()), axis.greville(0) + axis.length(), 1e-14);
}

TEST(Axis, GradedPlacesAndLengths) {
  const std::vector<double> breaks{0, 0.1, 0.15, 0.35, 0.6};
  const Axis axis(breaks, 2);
  EXPECT_EQ(axis.spacing(), 0.15 - 0.1);
  EXPECT_EQ(axis.element_at(-1), 0);
  EXPECT_EQ(axis.element_at(0.12), 1);
  EXPECT_EQ(axis.element_at(0.2), 2);
  EXPECT_EQ(axis.element_at(7), 3);
  EXPECT_EQ(axis.equal_parts(), 12);
  EXPECT_EQ(axis.equal_parts(2), 9);
  EXPECT_EQ(axis.end_or_middle(4), 0.15);
  EXPECT_EQ(axis.end_or_middle(5), 0.25);
  for (const Axis& a : {axis, Axis(breaks, 3), Axis(0.6, 7, 2)}) {
    const std::vector<double> integrals = a.integrals(0, a.length(), 0, a.elements());
    for (int i = 0; i < a.functions(); ++i) EXPECT_NEAR(a.integral(i), integrals[i], 1e-15);
  }
}

// Bernstein polynomials on one element: integrals 1/3 each; over [0, 1/2]: 7/24, 1/6, 1/24.
TEST(Axis, IntegralsOfBernsteinPolynomials) {
  const Axis axis(1.0, 1, 2);
  const std::vector<double> whole = axis.integrals(0, 1, 0, 1), half = axis.integrals(0, 0.5, 0, 1);
  for (double v : whole) EXPECT_NEAR(v, 1.0 / 3, 1e-15);
  EXPECT_NEAR(half[0], 7.0 / 24, 1e-15);
  EXPECT_NEAR(half[1], 1.0 / 6, 1e-15);
  EXPECT_NEAR(half[2], 1.0 / 24, 1e-15);
}

// Sum of integrals is the length, first moment by linear precision; a box may cut elements and be cut by the range.
TEST(Axis, IntegralsOfABox) {
  for (const Axis& axis : axes()) {
    const double a = 0.17, b = 0.59;
    const std::vector<double> w = axis.integrals(a, b, 0, axis.elements());
    double length = 0, moment = 0;
    for (int i = 0; i < axis.functions(); ++i) {
      length += w[i];
      moment += w[i] * axis.greville(i);
    }
    EXPECT_NEAR(length, b - a, 1e-14);
    EXPECT_NEAR(moment, 0.5 * (b * b - a * a), 1e-14);
    double cut = 0;
    for (double v : axis.integrals(a, b, 0, 2)) cut += v;
    EXPECT_NEAR(cut, axis.lower(2) - a, 1e-14);
  }
}

TEST(Axis, IntegralsAlongARadiusAreThoseOfRings) {
  for (const Axis& axis : {Axis(0.9, 7, 2, AxisKind::radial), Axis(uneven(7), 3, AxisKind::radial, 3)}) {
    EXPECT_EQ(axis.weight(0.3), 0.3);
    EXPECT_EQ(axis.functions(), axis.owned());
    double area = 0, moment = 0;  // int r dr and int r^2 dr, for the Greville points are the coordinate
    const std::vector<double> each = axis.integrals(0, axis.length(), 0, axis.elements());
    for (int i = 0; i < axis.functions(); ++i) area += each[i], moment += each[i] * axis.greville(i);
    EXPECT_NEAR(area, std::pow(axis.length(), 2) / 2, 1e-15);
    EXPECT_NEAR(moment, std::pow(axis.length(), 3) / 3, 1e-15);
  }
  EXPECT_EQ(Axis(0.9, 7, 2).weight(0.3), 1);
  EXPECT_EQ(Axis(0.9, 7, 2, AxisKind::periodic).weight(0.3), 1);
}

TEST(Axis, ElementAt) {
  const Axis axis(0.9, 9, 2);
  EXPECT_EQ(axis.element_at(-0.1), 0);
  EXPECT_EQ(axis.element_at(0.25), 2);
  EXPECT_EQ(axis.element_at(0.9), 8);
  EXPECT_EQ(axis.element_at(5), 8);
}

TEST(Gauss, ExactToDegree2nMinus1) {
  for (int n = 1; n <= 12; ++n) {
    const Gauss rule(n);
    for (int degree = 0; degree <= 2 * n; ++degree) {
      double sum = 0;
      for (int q = 0; q < n; ++q) sum += rule.weight[q] * std::pow(rule.point[q], degree);
      if (degree < 2 * n) {
        EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-15) << n << " points, degree " << degree;
      } else if (n < 8) {
        EXPECT_GT(std::abs(sum - 1.0 / (degree + 1)), 1e-12);
      }
    }
    for (int q = 1; q < n; ++q) EXPECT_GT(rule.point[q], rule.point[q - 1]);
  }
}

}  // namespace
}  // namespace softwet
