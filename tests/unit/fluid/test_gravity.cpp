// Gravity at a point.
#include "kernels/fluid/gravity.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/navier_stokes_korteweg.hpp"

namespace softwet {
namespace {

TEST(Gravity, ByHand) {
  const Gravity g{{2, -3, 0}, 0.4};
  const auto r = g.residual(DensityValueTrial<double, 2>{0.5});
  EXPECT_EQ(r.momentum[0], -1);
  EXPECT_EQ(r.momentum[1], 1.5);
  EXPECT_DOUBLE_EQ(r.mass_flux[0], -0.4 * 0.25 * 2);
  EXPECT_DOUBLE_EQ(r.mass_flux[1], 0.4 * 0.25 * 3);
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
    EXPECT_NEAR((at(e) - at(-e)) / (2 * e), g.residual(DensityValueTrial<double, 3>{rho}).momentum[i], 1e-12);
  }
}

// In a column at rest, grad mu = f, the forces cancel and the stabilisation moves no mass.
TEST(Gravity, BalancesTheGradientOfThePotential) {
  const double force[2] = {0.2, -0.3};
  const NavierStokesKorteweg fluid{{0.81, 0}, 3.0, 0.5, 0.1, 0.01};
  FluidTrial<double, 2> t{};
  t.density = 0.4;
  t.chemical_potential_gradient = {{force[0], force[1]}};
  const auto a = fluid.residual(t);
  const auto b = Gravity{{force[0], force[1], 0}, fluid.stabilisation}.residual(DensityValueTrial<double, 2>{0.4});
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(a.momentum[i] + b.momentum[i], 0, 1e-16);
    EXPECT_NEAR(a.mass_flux[i] + b.mass_flux[i], 0, 1e-16);
  }
}

}  // namespace
}  // namespace softwet
