// Coexistence and surface tension against an independent solution in extended precision.
#include "scene/equilibrium.hpp"

#include <gtest/gtest.h>

#include "case/case.hpp"
#include "case/error.hpp"

namespace softwet {
namespace {

struct EquilibriumRow {
  double theta, vapour, liquid, pressure, potential, sound_liquid, sound_vapour, tension;
};
const EquilibriumRow table[] = {
    {0.39, 0.001352289801, 0.8666990997, 1.546475127e-4, -0.6501910901, 2.183979206, 0.3363987816, 0.2532027493},
    {0.5, 0.007248935716, 0.8194973335, 1.029210928e-3, -0.5941013404, 1.705299831, 0.3685399457, 0.1915416203},
    {0.7, 0.04267410056, 0.7134808495, 7.424387670e-3, -0.5138467876, 1.048582202, 0.3754494221, 0.09240093455},
    {0.85, 0.1065766548, 0.6023801091, 1.868487592e-2, -0.4667444110, 0.6230687974, 0.3199521076, 0.03356246858},
    {0.95, 0.1930049756, 0.4872424479, 3.006960161e-2, -0.4398957867, 0.3100182300, 0.2149727617, 0.006570685483}};

TEST(Equilibrium, Table) {
  for (const EquilibriumRow& r : table) {
    const Coexistence s = coexistence(r.theta);
    const VanDerWaals gas{r.theta, 0};
    const auto sound = [&](double rho) { return std::sqrt(rho * gas.curvature(rho)); };
    EXPECT_NEAR(s.density_vapour, r.vapour, 1e-9 * r.vapour) << r.theta;
    EXPECT_NEAR(s.density_liquid, r.liquid, 1e-9 * r.liquid) << r.theta;
    EXPECT_NEAR(s.pressure, r.pressure, 1e-9 * r.pressure) << r.theta;
    EXPECT_NEAR(s.potential, r.potential, 1e-9) << r.theta;
    EXPECT_NEAR(sound(s.density_liquid), r.sound_liquid, 2e-9 * r.sound_liquid) << r.theta;
    EXPECT_NEAR(sound(s.density_vapour), r.sound_vapour, 2e-9 * r.sound_vapour) << r.theta;
    Fluid fluid;
    fluid.temperature = r.theta;
    fluid.capillarity = 0.5;
    EXPECT_NEAR(surface_tension(fluid), 0.5 * r.tension, 1e-9 * r.tension) << r.theta;
  }
}

TEST(Equilibrium, EqualPressureAndPotential) {
  for (const double theta : {0.3, 0.39, 0.62, 0.9, 0.99}) {
    const Coexistence s = coexistence(theta);
    const VanDerWaals gas{theta, 0};
    EXPECT_NEAR(gas.derivative(s.density_vapour), s.potential, 1e-13);
    EXPECT_NEAR(gas.derivative(s.density_liquid), s.potential, 1e-13);
    EXPECT_NEAR(gas.pressure(s.density_liquid), s.pressure, 1e-13);
  }
}

TEST(Equilibrium, DensitiesOfACurvedInterface) {
  const VanDerWaals gas{0.39, 0};
  const double potential = coexistence(0.39).potential + 0.01;
  const PhaseDensities r = densities_at(0.39, potential);
  EXPECT_NEAR(gas.derivative(r.vapour), potential, 1e-12);
  EXPECT_NEAR(gas.derivative(r.liquid), potential, 1e-12);
  EXPECT_LT(r.vapour, 0.1);
  EXPECT_GT(r.liquid, 0.8);
}

TEST(Equilibrium, OutsideOfTwoPhases) {
  for (const double theta : {0.0, 1.0, 1.5, -0.1}) EXPECT_THROW(coexistence(theta), Error) << theta;
}

TEST(Equilibrium, CloseToTheCriticalPoint) {
  for (const double theta : {1 - 1e-16, 1 - 1e-12, 1 - 1e-10}) EXPECT_THROW(coexistence(theta), Error) << 1 - theta;
  // Van der Waals: rho_l - rho_v = (4/3) sqrt(1 - theta) (rho_c = 1/3, reduced density 1 +- 2 sqrt(1 - theta)).
  const Coexistence s = coexistence(1 - 1e-6);
  EXPECT_NEAR(s.density_liquid - s.density_vapour, 4.0 / 3 * 1e-3, 2e-6);
}

}  // namespace
}  // namespace softwet
