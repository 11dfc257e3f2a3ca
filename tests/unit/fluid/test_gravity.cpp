// Gravity at a point.
#include "kernels/fluid/gravity.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/navier_stokes_korteweg.hpp"

namespace softwet {
namespace {

constexpr VanDerWaals plain_gas{0.81, 0};

/// What gravity adds to the momentum and to the flux of mass.
template <int D>
FluidTest<double, D> added(const NavierStokesKorteweg& heavy, const FluidTrial<double, D>& t) {
  NavierStokesKorteweg light = heavy;
  for (double& f : light.force) f = 0;
  FluidTest<double, D> r = heavy.residual(t);
  const FluidTest<double, D> without = light.residual(t);
  for (int i = 0; i < D; ++i) {
    r.momentum[i] -= without.momentum[i];
    r.mass_flux[i] -= without.mass_flux[i];
    for (int j = 0; j < D; ++j) EXPECT_NEAR(r.momentum_flux(i, j), without.momentum_flux(i, j), 1e-14);
  }
  EXPECT_NEAR(r.potential, without.potential, 1e-14);
  return r;
}

TEST(Gravity, ByHand) {
  FluidTrial<double, 2> t{};
  t.density = 0.5;
  const auto r = added<2>({plain_gas, 3.0, 0.5, 0.4, 0.01, {2, -3}}, t);
  EXPECT_EQ(r.momentum[0], -1);
  EXPECT_EQ(r.momentum[1], 1.5);
  EXPECT_DOUBLE_EQ(r.mass_flux[0], -0.4 * 0.25 * 2);
  EXPECT_DOUBLE_EQ(r.mass_flux[1], 0.4 * 0.25 * 3);
  const PlacedDensity<double, 2> at{{0.5}, {{4, 1}}};
  EXPECT_EQ((GravityEnergy{{2, -3}}.value(at)[0]), -0.5 * (2 * 4 - 3 * 1));
}

TEST(Gravity, TheForceIsMinusTheSlopeOfTheEnergy) {
  FluidTrial<double, 3> t{};
  t.density = 0.3;
  const auto r = added<3>({plain_gas, 3.0, 0.5, 0.0, 0.01, {2, -3, 5}}, t);
  const double e = 1e-3;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](double step) {
      PlacedDensity<double, 3> p{{t.density}, {{0.1, 0.2, 0.3}}};
      p.position[i] += step;
      return GravityEnergy{{2, -3, 5}}.value(p)[0];
    };
    EXPECT_NEAR((at(e) - at(-e)) / (2 * e), r.momentum[i], 1e-12);
  }
}

// In a column at rest, grad mu = f, the forces cancel and the stabilisation moves no mass.
TEST(Gravity, BalancesTheGradientOfThePotential) {
  const NavierStokesKorteweg fluid{plain_gas, 3.0, 0.5, 0.1, 0.01, {0.2, -0.3}};
  FluidTrial<double, 2> t{};
  t.density = 0.4;
  t.chemical_potential_gradient = {{0.2, -0.3}};
  const auto r = fluid.residual(t);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(r.momentum[i], 0);
    EXPECT_EQ(r.mass_flux[i], 0);
  }
}

}  // namespace
}  // namespace softwet
