// The two laws of the contact angle: by hand, and their limits.
#include "kernels/fluid/contact_angle.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

// Coexistence at theta = 0.39 (tests/oracle/wall_energy.py).
const Coexistence cold{0.001352289800692532, 0.86669909966079184, 0.0001546475126558792, -0.65019109012614495};

EnergyWall energy_wall(double smoothing) { return {0.1, 0.5, smoothing, {0.39, 0.2 * cold.density_vapour}, cold}; }

TEST(ContactAngle, GradientLawByHand) {
  const GradientWall law{0.2, 0.5, 0.0};
  const auto r = law.residual(DensityTrial<double, 3>{0.3, {{2, -6, 9}}});  // |grad rho| = 11
  EXPECT_NEAR(r.potential, 0.04 * 0.5 * 11, 1e-15);
  const auto s = GradientWall{0.2, -0.5, 0.0}.residual(DensityTrial<double, 3>{0.3, {{2, -6, 9}}});
  EXPECT_DOUBLE_EQ(s.potential, -r.potential);
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
  const double excess = -0.25 - cold.potential * rho + cold.pressure;
  EXPECT_NEAR(energy_wall(0).force(rho), 0.1 * 0.5 * std::sqrt(2 * excess), 1e-15);
  EXPECT_NEAR(energy_wall(d).force(rho), 0.1 * 0.5 * (std::sqrt(2 * excess + d * d) - d), 1e-15);
}

}  // namespace
}  // namespace softwet
