// The two laws of the contact angle: by hand, their limits, and the wall energy whose derivative the second one is.
#include "kernels/fluid/contact_angle.hpp"

#include <gtest/gtest.h>

#include "kernels/functional/fluid_integrals.hpp"

namespace softwet {
namespace {

// Coexistence at theta = 0.39 (an independent solution to ten digits).
const Coexistence cold{0.001352289801, 0.8666990997, 1.546475127e-4, -0.6501910901};
const double tension_over_capillarity = 0.2532027493;

EnergyWall energy_wall(double smoothing) { return {0.1, 0.5, smoothing, {0.39, 0.2 * cold.density_vapour}, cold}; }

TEST(ContactAngle, GradientLawByHand) {
  const GradientWall law{0.2, 0.5, 0.0};
  const auto r = law.residual(DensityTrial<double, 3>{0.3, {{2, -6, 9}}});  // |grad rho| = 11
  EXPECT_NEAR(r.potential, 0.04 * 0.5 * 11, 1e-15);
  const auto s = GradientWall{0.2, -0.5, 0.0}.residual(DensityTrial<double, 3>{0.3, {{2, -6, 9}}});
  EXPECT_EQ(s.potential, -r.potential);
}

// |grad rho| << d: the smoothed slope is d; |grad rho| >> d: it is |grad rho| to d^2 / (2 |grad rho|).
TEST(ContactAngle, GradientLawLimits) {
  const double d = 1e-4;
  const GradientWall law{1.0, 1.0, d};
  const auto at = [&](double slope) { return law.residual(DensityTrial<double, 2>{0.3, {{slope, 0}}}).potential; };
  EXPECT_NEAR(at(0), d, 1e-19);
  EXPECT_NEAR(at(1e-8), d, 1e-12);
  EXPECT_NEAR(at(3), 3 + d * d / 6, 1e-15);
  const Dual<double> slope =
      law.residual(DensityTrial<Dual<double>, 2>{{0.3}, {{Dual<double>(0.0, 1.0), {0.0}}}}).potential;
  EXPECT_EQ(slope.tangent, 0) << "differentiable where the density is uniform";
}

TEST(ContactAngle, EnergyLawVanishesInBothPhases) {
  const EnergyWall law = energy_wall(1e-5);
  EXPECT_NEAR(law.force(cold.density_vapour), 0, 1e-9);
  EXPECT_NEAR(law.force(cold.density_liquid), 0, 1e-9);
}

// Half way between the phases D is far above the smoothing: force = g cos(alpha) (sqrt(2 D + d^2) - d).
TEST(ContactAngle, EnergyLawByHand) {
  const double rho = 0.5, d = 1e-5;  // W(1/2) = -1/4
  const double excess = -0.25 + 0.6501910901 * rho + 1.546475127e-4;
  EXPECT_NEAR(energy_wall(0).force(rho), 0.1 * 0.5 * std::sqrt(2 * excess), 1e-15);
  EXPECT_NEAR(energy_wall(d).force(rho), 0.1 * 0.5 * (std::sqrt(2 * excess + d * d) - d), 1e-15);
}

TEST(ContactAngle, WallEnergyIsTheIntegralOfTheForce) {
  for (const double smoothing : {1e-5, 1e-3}) {
    const WallIntegrals wall{energy_wall(smoothing)};
    for (double rho = 0.02; rho < 0.9; rho += 0.043) {
      const double e = 1e-3;
      const double slope = (8 * (wall.wall_energy(rho + e) - wall.wall_energy(rho - e)) -
                            wall.wall_energy(rho + 2 * e) + wall.wall_energy(rho - 2 * e)) /
                           (12 * e);
      EXPECT_NEAR(slope, -wall.law.force(rho), 1e-9) << rho;
    }
    EXPECT_EQ(wall.wall_energy(cold.density_vapour), 0);
  }
}

// f_w(liquid) - f_w(vapour) = -cos(alpha) sigma: Young's law.
TEST(ContactAngle, WallEnergyGivesYoungsLaw) {
  const WallIntegrals wall{energy_wall(0)};
  EXPECT_NEAR(wall.wall_energy(cold.density_liquid), -0.5 * 0.1 * tension_over_capillarity, 1e-9 * 0.0126);
}

}  // namespace
}  // namespace softwet
