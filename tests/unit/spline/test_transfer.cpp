// Splines of one axis on another: the same function where the other space holds it.
#include "spline/transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

double value(const Axis& axis, const std::vector<double>& control, int element, double x) {
  const std::vector<double> b = axis.values(element, x);
  double sum = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const int function = axis.span(element) + static_cast<int>(k);
    sum += b[k] * control[axis.periodic() ? function % axis.owned() : function];
  }
  return sum;
}

std::vector<double> wild_control_values(int n) {
  std::vector<double> c(n);
  for (int i = 0; i < n; ++i) c[i] = std::sin(1 + 7.3 * i * i);
  return c;
}

std::vector<double> moved(const std::vector<TransferRow>& rows, const std::vector<double>& control) {
  std::vector<double> now;
  for (const TransferRow& row : rows) {
    double sum = 0;
    for (std::size_t k = 0; k < row.function.size(); ++k) sum += row.weight[k] * control[row.function[k]];
    now.push_back(sum);
  }
  return now;
}

/// Largest difference of the functions on the elements [low, high) of `to`.
double difference(const Axis& from, const std::vector<double>& a, const Axis& to, const std::vector<double>& b, int low,
                  int high, int from_low, int from_high) {
  double most = 0;
  for (int e = low; e < high; ++e)
    for (double part : {0.01, 0.3, 0.77, 0.99}) {
      const double x = to.lower(e) + part * to.spacing();
      const int old = std::min(std::max(from.element_at(x), from_low), from_high - 1);
      most = std::max(most, std::abs(value(from, a, old, x) - value(to, b, e, x)));
    }
  return most;
}

TEST(Projection, IsTheSameFunctionOnElementsThatDivideTheOthers) {
  constexpr AxisKind radial = AxisKind::radial;
  struct Pair {
    Axis from, to;
  };
  for (const auto& [from, to] :
       std::vector<Pair>{{Axis(0.9, 7, 2), Axis(0.9, 7, 2)},
                         {Axis(0.9, 7, 2), Axis(0.9, 14, 2)},
                         {Axis(0.9, 7, 2, AxisKind::periodic), Axis(0.9, 7, 2, AxisKind::periodic)},
                         {Axis(0.9, 7, 2, AxisKind::periodic), Axis(0.9, 21, 2, AxisKind::periodic)},
                         {Axis(0.9, 6, 2, AxisKind::bounded, 2), Axis(0.9, 6, 2, AxisKind::bounded, 2)},
                         {Axis(0.9, 6, 2, AxisKind::bounded, 2), Axis(0.9, 12, 2, AxisKind::bounded, 4)},
                         {Axis(1.3, 6, 3, AxisKind::bounded, 2), Axis(1.3, 18, 3, AxisKind::bounded, 6)},
                         {Axis(0.9, 7, 2, radial), Axis(0.9, 14, 2, radial)},
                         {Axis(1.3, 7, 3, radial), Axis(1.3, 21, 3, radial)},
                         {Axis(1.3, 7, 3, AxisKind::periodic), Axis(1.3, 14, 3, AxisKind::periodic)}}) {
    const std::vector<double> control = wild_control_values(from.functions());
    const auto rows = projection(from, 0, from.elements(), to, 0, to.elements());
    EXPECT_LT(difference(from, control, to, moved(rows, control), 0, to.elements(), 0, from.elements()), 1e-11)
        << from.elements() << " " << to.elements() << " degree " << to.degree();
  }
}

TEST(Projection, KeepsTheIntegralWithTheWeightOfTheAxis) {
  const std::vector<double> uneven{0, 0.07, 0.2, 0.35, 0.6, 0.9};
  for (const AxisKind kind : {AxisKind::bounded, AxisKind::radial, AxisKind::periodic})
    for (const Axis& to : {Axis(0.9, 5, 2, kind), Axis(0.9, 11, 3, kind), Axis(uneven, 2, kind)}) {
      const Axis from(0.9, 8, 2, kind);
      const auto integral = [](const Axis& axis, const std::vector<double>& control) {
        const std::vector<double> each = axis.integrals(0, axis.length(), 0, axis.elements());
        double sum = 0;
        for (int i = 0; i < axis.functions(); ++i) sum += each[i] * control[i % axis.owned()];
        return sum;
      };
      const std::vector<double> control = wild_control_values(from.functions());
      const double before = integral(from, control);
      const auto rows = projection(from, 0, from.elements(), to, 0, to.elements());
      EXPECT_NEAR(integral(to, moved(rows, control)), before, 1e-13) << to.elements();
    }
}

TEST(Projection, KeepsTheIntegralOnItsSideOfTheWall) {
  const Axis from(0.9, 6, 2, AxisKind::bounded, 2), to(0.9, 9, 2, AxisKind::bounded, 3);
  std::vector<double> control = wild_control_values(from.functions());
  for (int i = 0; i < from.span(2); ++i) control[i] = NAN;  // the fluid has no values below the wall
  const std::vector<double> now = moved(projection(from, 2, 6, to, 3, 9), control);
  const std::vector<double> old_parts = from.integrals(0.3, 0.9, 2, 6), parts = to.integrals(0.3, 0.9, 3, 9);
  double before = 0, after = 0;
  for (int i = from.span(2); i < from.functions(); ++i) before += old_parts[i] * control[i];
  for (int i = to.span(3); i < to.functions(); ++i) after += parts[i] * now[i];
  EXPECT_NEAR(after, before, 1e-13);
}

TEST(Projection, StaysOnItsSideOfTheWall) {
  const Axis from(0.9, 6, 2, AxisKind::bounded, 2), to(0.9, 12, 2, AxisKind::bounded, 4);
  std::vector<double> control = wild_control_values(from.functions());
  for (int i = 0; i < from.span(2); ++i) control[i] = NAN;  // the fluid has no values below the wall
  const std::vector<double> now = moved(projection(from, 2, 6, to, 4, 12), control);
  EXPECT_LT(difference(from, control, to, now, 4, 12, 2, 6), 1e-12);
  control = wild_control_values(from.functions());
  for (int i = from.span(2) + 1; i < from.functions(); ++i) control[i] = NAN;  // nor the solid above it
  const std::vector<double> below = moved(projection(from, 0, 2, to, 0, 4), control);
  EXPECT_LT(difference(from, control, to, below, 0, 4, 0, 2), 1e-12);
}

TEST(Projection, ConvergesOnOtherElementsAndDegrees) {
  // A spline on many elements is nearly smooth: on few elements the error falls like the fourth power for degree 3.
  const Axis smooth(1, 4000, 3);
  std::vector<double> control;
  for (int i = 0; i < smooth.functions(); ++i) control.push_back(std::sin(5 * smooth.greville(i)));
  const auto error = [&](int n) {
    const Axis few(1, n, 3);
    return difference(smooth, control, few, moved(projection(smooth, 0, 4000, few, 0, n), control), 0, n, 0, 4000);
  };
  EXPECT_NEAR(std::log2(error(26) / error(52)), 4, 0.5);
  const Axis from(1, 8, 2), to(1, 8, 3);
  const std::vector<double> line(from.functions(), 0.7);
  for (const double c : moved(projection(from, 0, 8, to, 0, 8), line)) EXPECT_NEAR(c, 0.7, 1e-13);
}

// Values at ends and middles of elements determine a spline of degree 2, also at a kink, on a part of an axis, around a
// periodic axis and on graded elements.
TEST(Samples, HoldASplineOfDegreeTwo) {
  const Axis equal(1.3, 7, 2), kinked(1.3, 7, 2, AxisKind::bounded, 3), periodic(1.3, 7, 2, AxisKind::periodic),
      graded(std::vector<double>{0, 0.1, 0.2, 0.35, 0.6, 1.3}, 2);
  for (const Axis& axis : {equal, kinked, periodic, graded}) {
    const int low = axis.kink(), high = axis.elements();
    std::vector<double> control, samples;
    for (int i = 0; i < axis.functions(); ++i) control.push_back(std::cos(3.0 * (i % axis.owned())));
    for (int k = 2 * low; k <= 2 * high; ++k) {
      const int element = std::min(k / 2, high - 1);
      samples.push_back(value(axis, control, element, axis.end_or_middle(k)));
    }
    const std::vector<TransferRow> rows = from_samples(axis, low, high);
    for (int i = axis.span(low); i < axis.functions(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < rows[i].function.size(); ++k) sum += rows[i].weight[k] * samples[rows[i].function[k]];
      EXPECT_NEAR(sum, control[i], 1e-12) << i;
    }
  }
}

}  // namespace
}  // namespace softwet
