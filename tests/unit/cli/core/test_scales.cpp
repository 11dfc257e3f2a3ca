// Physical numbers and the numbers of a case: the paper's scales.
#include "cli/core/scales.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

/// Worked by hand: theta 0.39, gamma 0.02, so rho_hat_l = 0.8666990997 and sigma_hat = 0.02 x 0.2532027493.
PhysicalScene water() {
  PhysicalScene p;
  p.radius = 1e-4;
  p.length = 1e-3;
  p.surface_tension = 0.072;
  p.density = 1000;
  p.viscosity = 1e-3;
  p.young = 3000;
  p.solid_density = 1100;
  p.thickness = 2e-4;
  p.capillarity = 0.02;
  return p;
}

TEST(Scales, ByHand) {
  const Scales s = scales_of(water());
  const double b = 1000 / 0.8666990997, stress = 0.072 / (0.02 * 0.2532027493 * 1e-3);
  EXPECT_NEAR(s.density, b, 1e-6 * b);
  EXPECT_NEAR(s.stress(), stress, 1e-7 * stress);
  EXPECT_NEAR(s.velocity(), std::sqrt(stress / b), 1e-6);
  EXPECT_NEAR(s.time(), 1e-3 / std::sqrt(stress / b), 1e-9);
  const Case c = case_of(water(), s);
  EXPECT_NEAR(c.fluid->viscosity, 1e-3 / (1e-3 * std::sqrt(stress * b)), 1e-9);
  EXPECT_NEAR(c.substrate->young_modulus(), 3000 / stress, 1e-8);
  EXPECT_NEAR(c.substrate->density, 1100 / b, 1e-8);
  EXPECT_NEAR(c.substrate->thickness, 0.2, 1e-14);
  EXPECT_NEAR(c.droplets.at(0).radius, 0.1, 1e-14);
}

TEST(Scales, TensionAndViscosityOfTheSolid) {
  PhysicalScene p = water();
  p.solid_tension = 0.036;
  p.solid_viscosity = 20;
  const Scales s = scales_of(p);
  const double sigma = 0.02 * 0.2532027493;  // of the liquid in the case
  Case c = case_of(p, s);
  EXPECT_NEAR(c.substrate->surface_tension, 0.5 * sigma, 1e-8 * sigma);
  EXPECT_NEAR(c.substrate->surface_tension_wet, 0.5 * sigma, 1e-8 * sigma) << "that of the dry solid";
  EXPECT_NEAR(c.substrate->viscosity / c.fluid->viscosity, 20 / 1e-3, 1e-6);
  p.wet_tension = 0.018;
  c = case_of(p, s);
  EXPECT_NEAR(c.substrate->surface_tension_wet, 0.25 * sigma, 1e-8 * sigma);
  EXPECT_EQ(case_of(water(), s).substrate->surface_tension, 0);
}

TEST(Scales, Defaults) {
  PhysicalScene p = water();
  p.length = p.capillarity = p.solid_density = p.thickness = 0;
  const Scales s = scales_of(p);
  const Case c = case_of(p, s);
  EXPECT_NEAR(c.droplets.at(0).radius, 0.15, 1e-14);
  EXPECT_NEAR(c.fluid->capillarity, 0.015, 1e-14);
  EXPECT_NEAR(c.substrate->thickness, 0.15, 1e-14);
  EXPECT_NEAR(c.substrate->density, 0.8666990997, 1e-8);
  p.young = 0;
  EXPECT_FALSE(case_of(p, s).substrate);
}

}  // namespace
}  // namespace softwet
