// Saint Venant-Kirchhoff material against closed forms and its own energy.
#include "kernels/solid/saint_venant_kirchhoff.hpp"

#include "material_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(SaintVenantKirchhoff, LameParameters) {
  const auto m = LameParameters::from(2.6, 0.3);
  EXPECT_NEAR(m.shear_modulus, 1.0, 1e-15);
  EXPECT_NEAR(m.lambda, 1.5, 1e-14);
  EXPECT_EQ(LameParameters::from(2.6, 0.0).lambda, 0);
}

// Stretch s along x, plane strain: E_xx = (s^2 - 1)/2, P_xx = s (lambda + 2 G) E_xx, P_yy = lambda E_xx.
TEST(SaintVenantKirchhoff, UniaxialStretch) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double s = 1.3, e = 0.5 * (s * s - 1);
  const auto p = m.first_piola(Matrix<double, 2>{{{s - 1, 0}, {0, 0}}});
  EXPECT_NEAR(p(0, 0), s * (1.5 + 1.4) * e, 1e-15);
  EXPECT_NEAR(p(1, 1), 1.5 * e, 1e-15);
  EXPECT_EQ(p(0, 1), 0);
  EXPECT_NEAR(m.energy(Matrix<double, 2>{{{s - 1, 0}, {0, 0}}}), (0.75 + 0.7) * e * e, 1e-15);
}

// x = X + k Y: E_xy = k/2, E_yy = k^2/2; S_xx = lambda k^2/2, S_xy = G k, S_yy = (lambda/2 + G) k^2; P = F S.
TEST(SaintVenantKirchhoff, SimpleShear) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double k = 0.4, sxx = 0.75 * k * k, sxy = 0.7 * k, syy = (0.75 + 0.7) * k * k;
  const auto p = m.first_piola(Matrix<double, 2>{{{0, k}, {0, 0}}});
  EXPECT_NEAR(p(0, 0), sxx + k * sxy, 1e-15);
  EXPECT_NEAR(p(0, 1), sxy + k * syy, 1e-15);
  EXPECT_NEAR(p(1, 0), sxy, 1e-15);
  EXPECT_NEAR(p(1, 1), syy, 1e-15);
}

TEST(SaintVenantKirchhoff, RotationIsFree) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double c = std::cos(0.9), s = std::sin(0.9);
  const Matrix<double, 3> g{{{c - 1, -s, 0}, {s, c - 1, 0}, {0, 0, 0}}};
  EXPECT_NEAR(m.energy(g), 0, 1e-30);
  const auto p = m.first_piola(g);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(p(i, j), 0, 1e-15);
}

// The frame does not matter: for a rotation Q, energy(Q F) = energy(F) and P(Q F) = Q P(F).
TEST(SaintVenantKirchhoff, RotationOfADeformedStateTurnsTheStress) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double c = std::cos(2.3), s = std::sin(2.3);
  const double q[2][2] = {{c, -s}, {s, c}};
  const Matrix<double, 2> g{{{0.3, 0.4}, {-0.2, 0.1}}};
  const auto turn = [&](const Matrix<double, 2>& a) {
    Matrix<double, 2> b;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) b(i, j) = q[i][0] * a(0, j) + q[i][1] * a(1, j);
    return b;
  };
  Matrix<double, 2> f = g;
  for (int i = 0; i < 2; ++i) f(i, i) += 1;
  Matrix<double, 2> turned = turn(f);
  for (int i = 0; i < 2; ++i) turned(i, i) -= 1;
  EXPECT_NEAR(m.energy(turned), m.energy(g), 1e-15);
  const auto p = m.first_piola(turned), expected = turn(m.first_piola(g));
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(p(i, j), expected(i, j), 1e-14);
}

// Small strains: P is the linear stress lambda tr(e) I + 2 G e up to second order.
TEST(SaintVenantKirchhoff, SmallStrainsAreLinear) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double h = 1e-6;
  const auto p = m.first_piola(Matrix<double, 2>{{{2 * h, 3 * h}, {-h, 5 * h}}});
  EXPECT_NEAR(p(0, 0) / h, 1.5 * 7 + 1.4 * 2, 1e-4);
  EXPECT_NEAR(p(0, 1) / h, 0.7 * 2, 1e-4);
  EXPECT_NEAR(p(1, 0) / h, 0.7 * 2, 1e-4);
}

// The energy is a polynomial of fourth degree, for which the differences are exact.
TEST(SaintVenantKirchhoff, StressIsTheDerivativeOfTheEnergy) {
  expect_stress_of_energy<2>(SaintVenantKirchhoff{{1.5, 0.7}}, 1e-12);
  expect_stress_of_energy<3>(SaintVenantKirchhoff{{1.5, 0.7}}, 1e-12);
}
TEST(SaintVenantKirchhoff, PlaneStrain) { expect_plane_strain(SaintVenantKirchhoff{{1.5, 0.7}}, 1e-16); }

// Stretches s and r along x and y in plane strain: J = s r, E = diag((s^2 - 1)/2, (r^2 - 1)/2, 0) and
// S = lambda tr(E) I + 2 G E; P_ii = F_ii S_ii; sigma_ii = F_ii^2 S_ii / J. Along z, F_zz = 1 and S_zz = lambda tr(E).
TEST(SaintVenantKirchhoff, CauchyStressOfTwoStretches) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double s = 1.3, r = 0.8, ex = 0.345, ey = -0.18, tr = ex + ey;
  const Matrix<double, 3> g{{{s - 1, 0, 0}, {0, r - 1, 0}, {0, 0, 0}}};
  EXPECT_NEAR(volume_ratio(g), 1.04, 1e-15);
  const auto p = m.first_piola(g), cauchy = cauchy_stress(m.first_piola(g), g);
  EXPECT_NEAR(p(2, 2), 1.5 * tr, 1e-15);
  EXPECT_NEAR(cauchy(0, 0), s * s * (1.5 * tr + 1.4 * ex) / 1.04, 1e-15);
  EXPECT_NEAR(cauchy(1, 1), r * r * (1.5 * tr + 1.4 * ey) / 1.04, 1e-15);
  EXPECT_NEAR(cauchy(2, 2), 1.5 * tr / 1.04, 1e-15);
  EXPECT_EQ(cauchy(0, 1), 0);
  EXPECT_EQ(cauchy(1, 2), 0);
}

// Power of the Cauchy stress: stretching the deformed body by x -> x + e L x changes the stored energy of a reference
// volume by e J sigma : L.
TEST(SaintVenantKirchhoff, CauchyStressIsWorkOnTheDeformedBody) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const Matrix<double, 3> g{{{0.3, 0.4, -0.1}, {-0.2, 0.1, 0.2}, {0.15, -0.05, -0.25}}};
  const Matrix<double, 3> f = add_diagonal(g, 1.0), cauchy = cauchy_stress(m.first_piola(g), g);
  const double j = volume_ratio(g), e = 1e-3;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      EXPECT_NEAR(cauchy(a, b), cauchy(b, a), 1e-15);
      const auto at = [&](double step) {
        Matrix<double, 3> moved = g;
        for (int k = 0; k < 3; ++k) moved(a, k) += step * f(b, k);
        return m.energy(moved);
      };
      EXPECT_NEAR((8 * (at(e) - at(-e)) - at(2 * e) + at(-2 * e)) / (12 * e), j * cauchy(a, b), 1e-11);
    }
}

TEST(SaintVenantKirchhoff, RotationHasNoStressAndKeepsTheVolume) {
  const SaintVenantKirchhoff m{{1.5, 0.7}};
  const double c = std::cos(0.9), s = std::sin(0.9);
  const Matrix<double, 3> g{{{c - 1, -s, 0}, {s, c - 1, 0}, {0, 0, 0}}};
  EXPECT_NEAR(volume_ratio(g), 1, 1e-15);
  const auto cauchy = cauchy_stress(m.first_piola(g), g), e = m.strain(g);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(cauchy(i, j), 0, 1e-15);
      EXPECT_NEAR(e(i, j), 0, 1e-15);
    }
}

}  // namespace
}  // namespace softwet::testing_tools
