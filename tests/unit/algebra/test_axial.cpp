// A tensor with a hoop entry does what the 3 x 3 matrix does that it stands for, also in the laws of fluid and solid.
#include "kernels/algebra/axial.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/fluid/korteweg.hpp"
#include "kernels/fluid/newtonian.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/kelvin_voigt.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {
namespace {

class Axial : public testing::Test {
 protected:
  AxialMatrix<double> draw(double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    AxialMatrix<double> m;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) m(i, j) = uniform(random_);
    m.hoop = uniform(random_);
    return m;
  }

 private:
  std::mt19937 random_{20261127};
};

/// The third axis is the angle.
Matrix<double, 3> full(const AxialMatrix<double>& a) {
  Matrix<double, 3> m{};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) m(i, j) = a(i, j);
  m(2, 2) = a.hoop;
  return m;
}

void expect_same(const AxialMatrix<double>& a, const Matrix<double, 3>& b) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(full(a)(i, j), b(i, j), 1e-14) << i << ", " << j;
}

TEST_F(Axial, AlgebraIsThatOfTheFullMatrix) {
  for (int k = 0; k < 20; ++k) {
    const AxialMatrix<double> a = draw(1), b = draw(1);
    expect_same(a + b, full(a) + full(b));
    expect_same(0.7 * a, 0.7 * full(a));
    expect_same(product(a, b), product(full(a), full(b)));
    expect_same(transpose(a), transpose(full(a)));
    expect_same(add_diagonal(a, 0.3), add_diagonal(full(a), 0.3));
    expect_same(cofactor(a), cofactor(full(a)));
    EXPECT_NEAR(trace(a), trace(full(a)), 1e-15);
    EXPECT_NEAR(contract(a, b), contract(full(a), full(b)), 1e-15);
    EXPECT_NEAR(determinant(a, cofactor(a)), determinant(full(a), cofactor(full(a))), 1e-15);
  }
}

TEST_F(Axial, StressesOfTheFluidAreThoseInSpace) {
  for (int k = 0; k < 20; ++k) {
    const AxialMatrix<double> g = draw(1);
    expect_same(newtonian_stress(0.3, g), newtonian_stress(0.3, full(g)));
    const Vector<double, 2> slope{{g(0, 0), g(0, 1)}};
    expect_same(reversible_stress<double, 2, AxialMatrix<double>>(0.2, 0.4, 0.5, slope, -0.3),
                reversible_stress(0.2, 0.4, 0.5, Vector<double, 3>{{slope[0], slope[1], 0}}, -0.3));
  }
}

template <class Material>
void expect_same_material(const Material& m, const AxialMatrix<double>& g) {
  expect_same(m.strain(g), m.strain(full(g)));
  expect_same(m.first_piola(g), m.first_piola(full(g)));
  EXPECT_NEAR(m.energy(g), m.energy(full(g)), 1e-14);
  EXPECT_NEAR(volume_ratio(g), volume_ratio(full(g)), 1e-14);
}

TEST_F(Axial, SolidsAreThoseInSpace) {
  const LameParameters stiffness = LameParameters::from(2, 0.3);
  for (int k = 0; k < 20; ++k) {
    const AxialMatrix<double> g = draw(0.3), rate = draw(1);
    expect_same_material(SaintVenantKirchhoff{stiffness}, g);
    expect_same_material(Hooke{stiffness}, g);
    expect_same_material(NeoHookean{stiffness}, g);
    const KelvinVoigt viscous{0.2, 0.1};
    using M = AxialMatrix<double>;
    const SolidStrainRate<double, 2, M> axial{g, rate};
    const SolidStrainRate<double, 3> space{full(g), full(rate)};
    expect_same(viscous.residual(axial).momentum_flux, viscous.residual(space).momentum_flux);
    EXPECT_NEAR(viscous.dissipation(axial), viscous.dissipation(space), 1e-14);
  }
}

}  // namespace
}  // namespace softwet
