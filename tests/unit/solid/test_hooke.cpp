// Linear elasticity by hand.
#include "kernels/solid/hooke.hpp"

#include "material_checks.hpp"

namespace softwet::testing_tools {
namespace {

// P = lambda tr(e) I + 2 G e with e = (Grad u + Grad u^T)/2, energy P:e/2; P is the Cauchy stress.
TEST(Hooke, ByHand) {
  const Hooke m{{1.5, 1.0}};
  const Matrix<double, 2> g{{{0.3, 0.4}, {-0.2, 0.1}}};
  const auto p = m.first_piola(g);
  EXPECT_NEAR(p(0, 0), 1.5 * 0.4 + 2 * 0.3, 1e-15);
  EXPECT_NEAR(p(0, 1), 0.2, 1e-15);
  EXPECT_NEAR(p(1, 0), 0.2, 1e-15);
  EXPECT_NEAR(p(1, 1), 1.5 * 0.4 + 2 * 0.1, 1e-15);
  EXPECT_NEAR(m.energy(g), 0.5 * (p(0, 0) * 0.3 + 0.2 * 0.2 + p(1, 1) * 0.1), 1e-15);
}

TEST(Hooke, StressIsTheDerivativeOfTheEnergy) {
  expect_stress_of_energy<2>(Hooke{{1.5, 0.7}});
  expect_stress_of_energy<3>(Hooke{{1.5, 0.7}});
}
TEST(Hooke, PlaneStrain) { expect_plane_strain(Hooke{{1.5, 0.7}}); }

}  // namespace
}  // namespace softwet::testing_tools
