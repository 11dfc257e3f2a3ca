// Gravity at a point.
#include "kernels/fluid/gravity.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

TEST(Gravity, ByHand) {
  const Gravity g{{2, -3, 0}};
  const auto r = g.residual(DensityValueTrial<double, 2>{0.5});
  EXPECT_EQ(r.value[0], -1);
  EXPECT_EQ(r.value[1], 1.5);
  const PlacedDensity<double, 2> at{{0.5}, {{4, 1}}};
  EXPECT_EQ(GravityEnergy{g}.value(at)[0], -0.5 * (2 * 4 - 3 * 1));
}

TEST(Gravity, TheForceIsMinusTheSlopeOfTheEnergy) {
  const Gravity g{{2, -3, 5}};
  const double rho = 0.3, e = 1e-3;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](double step) {
      PlacedDensity<double, 3> p{{rho}, {{0.1, 0.2, 0.3}}};
      p.position[i] += step;
      return GravityEnergy{g}.value(p)[0];
    };
    EXPECT_NEAR((at(e) - at(-e)) / (2 * e), g.residual(DensityValueTrial<double, 3>{rho}).value[i], 1e-12);
  }
}

}  // namespace
}  // namespace softwet
