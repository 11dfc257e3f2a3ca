// Control values of functions of the place.
#include "spline/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

std::vector<double> growing(double coarsest) {
  std::vector<double> breaks{0};
  for (int e = 0; e < 30; ++e)
    breaks.push_back(breaks.back() + std::min(coarsest, std::pow(1.3, std::max(0, std::abs(e - 15) - 6))) / 30);
  return breaks;
}

TEST(Sampling, EqualElementsTakeGrevillePoints) {
  for (const Axis& axis :
       {Axis(0.9, 7, 2), Axis(0.9, 7, 3, AxisKind::bounded, 3), Axis(0.9, 7, 2, AxisKind::periodic)}) {
    const std::vector<Samples> samples = samples_of(axis);
    ASSERT_EQ(static_cast<int>(samples.size()), axis.functions());
    for (int i = 0; i < axis.functions(); ++i) {
      EXPECT_EQ(samples[i].place, std::vector<double>{axis.greville(i)});
      EXPECT_EQ(samples[i].weight, std::vector<double>{1.0});
    }
  }
}

TEST(Sampling, WeightsArePositiveAndAddUpToOneAtTheGrevillePoint) {
  for (const Axis& axis :
       {Axis(growing(4), 2), Axis(growing(4), 3, AxisKind::bounded, 15), Axis(growing(4), 2, AxisKind::periodic)})
    for (const Samples& s : samples_of(axis)) {
      double one = 0;
      for (const double w : s.weight) {
        EXPECT_GT(w, 0);
        one += w;
      }
      EXPECT_NEAR(one, 1, 1e-14);
    }
}

// Sampled at Greville points the spline has another integral than the function. Around an axis of symmetry integrals
// have the weight x.
TEST(Sampling, TheIntegralIsThatOfTheFunction) {
  std::vector<double> breaks{0};
  for (int e = 0; e < 40; ++e) breaks.push_back(breaks.back() + 0.03 + 0.01 * std::sin(3.1 * e * e));
  for (const int degree : {2, 3})
    for (const AxisKind kind : {AxisKind::bounded, AxisKind::radial}) {
      const Axis axis(breaks, degree, kind);
      const double middle = 0.5 * axis.length(), width = 0.15 * axis.length();
      const auto bump = [&](double x) { return std::exp(-std::pow((x - middle) / width, 2)); };
      const double exact = width * std::sqrt(M_PI) * std::erf(middle / width) * (kind == AxisKind::radial ? middle : 1);
      const std::vector<Samples> samples = samples_of(axis);
      const std::vector<double> integrals = axis.integrals(0, axis.length(), 0, axis.elements());
      double sum = 0, at_greville = 0;
      for (int i = 0; i < axis.functions(); ++i) {
        at_greville += bump(axis.greville(i)) * integrals[i];
        for (std::size_t k = 0; k < samples[i].place.size(); ++k)
          sum += samples[i].weight[k] * bump(samples[i].place[k]) * integrals[i];
      }
      EXPECT_LT(std::abs(sum - exact), 1e-6 * exact);
      EXPECT_GT(std::abs(at_greville - exact), 1e-5 * exact);
    }
}

}  // namespace
}  // namespace softwet
