// Neo-Hookean material against closed forms and its own energy.
#include "kernels/solid/neo_hookean.hpp"

#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "material_checks.hpp"

namespace softwet::testing_tools {
namespace {

const NeoHookean material{{1.5, 0.7}};

// Stretch s along x in plane strain: J = s, P_xx = G (s - 1/s) + lambda ln(s)/s, P_yy = lambda ln(s).
TEST(NeoHookean, UniaxialStretch) {
  for (const double s : {0.2, 0.9, 1.0, 1.3, 4.0}) {
    const Matrix<double, 2> g{{{s - 1, 0}, {0, 0}}};
    const auto p = material.first_piola(g);
    EXPECT_NEAR(p(0, 0), 0.7 * (s - 1 / s) + 1.5 * std::log(s) / s, 1e-14);
    EXPECT_NEAR(p(1, 1), 1.5 * std::log(s), 1e-14);
    EXPECT_NEAR(p(0, 1), 0, 1e-15);
    EXPECT_NEAR(material.energy(g), 0.35 * (s * s - 1) - 0.7 * std::log(s) + 0.75 * std::pow(std::log(s), 2), 1e-14);
  }
}

// x = X + k Y keeps the volume: the Cauchy stress is G (b - I) with b = F F^T, so sigma_xy = G k, sigma_xx = G k^2.
TEST(NeoHookean, SimpleShear) {
  const double k = 0.8;
  const Matrix<double, 3> gradient{{{0, k, 0}, {0, 0, 0}, {0, 0, 0}}};
  const auto sigma = cauchy_stress(material.first_piola(gradient), gradient);
  EXPECT_NEAR(sigma(0, 1), 0.7 * k, 1e-15);
  EXPECT_NEAR(sigma(1, 0), 0.7 * k, 1e-15);
  EXPECT_NEAR(sigma(0, 0), 0.7 * k * k, 1e-15);
  EXPECT_NEAR(sigma(1, 1), 0, 1e-15);
}

TEST(NeoHookean, StressIsTheDerivativeOfTheEnergy) {
  expect_stress_of_energy<2>(material);
  expect_stress_of_energy<3>(material);
}
TEST(NeoHookean, HookesLawInTheLimit) { expect_hooke_in_the_limit(material); }
TEST(NeoHookean, PlaneStrain) { expect_plane_strain(material); }

TEST(NeoHookean, RotationIsFree) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Matrix<double, 2> g{{{c - 1, -s}, {s, c - 1}}};
  const auto p = material.first_piola(g);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(p(i, j), 0, 2e-15);
  EXPECT_NEAR(material.energy(g), 0, 1e-15);
}

// Under compression the stress goes on growing; the stress of Saint Venant-Kirchhoff falls off again.
TEST(NeoHookean, StaysStiffUnderCompression) {
  const SaintVenantKirchhoff soft{{1.5, 0.7}};
  const auto stress = [](const auto& m, double s) {
    return m.first_piola(Matrix<double, 2>{{{s - 1, 0}, {0, 0}}})(0, 0);
  };
  EXPECT_LT(stress(material, 0.2), 2 * stress(material, 0.5));
  EXPECT_GT(stress(soft, 0.2), stress(soft, 0.5));
}

}  // namespace
}  // namespace softwet::testing_tools
