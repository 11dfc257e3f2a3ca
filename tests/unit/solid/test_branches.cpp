// Branches of a viscoelastic solid: stress and energy at a point, and how they stiffen a step.
#include "kernels/solid/branches.hpp"

#include <gtest/gtest.h>

#include <random>

namespace softwet::branches {
namespace {

template <int D>
Matrix<double, D> random_matrix() {
  static std::mt19937 random(20261128);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix<double, D> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = uniform(random);
  return m;
}
Matrix<Dual<double>, 2> moved(const Matrix<double, 2>& g, const Matrix<double, 2>& by) {
  Matrix<Dual<double>, 2> m;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) m(i, j) = {g(i, j), by(i, j)};
  return m;
}
/// The 3 x 3 matrix that a plane or axisymmetric gradient stands for.
Matrix<double, 3> whole(const Matrix<double, 2>& g, double hoop) {
  Matrix<double, 3> m{};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) m(i, j) = g(i, j);
  m(2, 2) = hoop;
  return m;
}
template <int D>
Matrix<double, D> stress(const Matrix<double, D>& g) {
  return BranchStress{}.residual(LagStrain<double, D>{g}).momentum_flux;
}
template <int D>
double square(const Matrix<double, D>& g) {
  return ShearSquare{}.value(LagStrain<double, D>{g})[0];
}

TEST(Branches, StressInThePlaneAndAboutAnAxisIsThatOfSpace) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, 2> g = random_matrix<2>();
    const double hoop = random_matrix<2>()(0, 0);
    const LagStrain<double, 2, AxialMatrix<double>> around{{g, hoop}};
    const auto axial = BranchStress{}.residual(around).momentum_flux;
    const Matrix<double, 2> plane = stress<2>(g);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        EXPECT_NEAR(plane(i, j), stress<3>(whole(g, 0))(i, j), 1e-15);
        EXPECT_NEAR(axial(i, j), stress<3>(whole(g, hoop))(i, j), 1e-15);
      }
    EXPECT_NEAR(axial.hoop, stress<3>(whole(g, hoop))(2, 2), 1e-15);
    EXPECT_NEAR(square<2>(g), square<3>(whole(g, 0)), 1e-15);
    EXPECT_NEAR(ShearSquare{}.value(around)[0], square<3>(whole(g, hoop)), 1e-14);
  }
}

// dev e : dev e / 2 is the energy of the stress dev e: its derivative, and the half of its product with the strain.
TEST(Branches, StressIsTheDerivativeOfTheEnergy) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, 2> g = random_matrix<2>(), by = random_matrix<2>();
    const Dual<double> energy = 0.5 * ShearSquare{}.value(LagStrain<Dual<double>, 2>{moved(g, by)})[0];
    EXPECT_NEAR(energy.tangent, contract(stress<2>(g), by), 1e-14);
    const Matrix<double, 3> h = random_matrix<3>();
    EXPECT_NEAR(square<3>(h), contract(stress<3>(h), h), 1e-14);
    EXPECT_GT(square<3>(h), 0);
  }
}

TEST(Branches, FeelNeitherVolumeNorRotation) {
  Matrix<double, 3> g{};
  for (int i = 0; i < 3; ++i) g(i, i) = 0.7;
  g(0, 1) = 0.4;
  g(1, 0) = -0.4;
  EXPECT_NEAR(square<3>(g), 0, 1e-15);
  EXPECT_NEAR(stress<3>(g)(0, 1), 0, 1e-15);
  EXPECT_NEAR(stress<3>(g)(1, 1), 0, 1e-15);
}

// A step that is short against the time of a branch meets its spring, 2 G; a long one its dashpot, 2 G tau / c.
TEST(Branches, MeetAStepByTheirTimes) {
  Branches b;
  b.count = 2;
  b.modulus[0] = 0.3;
  b.time[0] = 10;
  b.modulus[1] = 2;
  b.time[1] = 0.01;
  EXPECT_NEAR(b.weight(0, 1e-9), 0.6, 1e-9);
  EXPECT_NEAR(b.weight(1, 1e3), 2 * 2 * 0.01 / 1e3, 1e-8);
  EXPECT_NEAR(b.weight(0.5), b.weight(0, 0.5) + b.weight(1, 0.5), 1e-15);
  EXPECT_EQ(Branches{}.weight(0.5), 0);
}

// --- Finite strains
// ------------------------------------------------------------------------------------------------------

template <class N, int D, class M>
RememberedStrain<N, D, M> strained(const M& gradient, const Matrix<double, 3>& memory) {
  RememberedStrain<N, D, M> t;
  t.displacement_gradient = gradient;
  t.remembers = true;
  int k = 0;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) t.memory[k++] = N(memory(i, j));
  if constexpr (is_axial_matrix<M>) t.memory[k] = N(memory(2, 2));
  return t;
}
template <int D>
RememberedStrain<double, D> strained(const Matrix<double, D>& gradient, const Matrix<double, 3>& memory) {
  return strained<double, D, Matrix<double, D>>(gradient, memory);
}
Matrix<double, 3> symmetric(const Matrix<double, 3>& a) { return 0.5 * (a + transpose(a)); }

TEST(FiniteBranches, StressInThePlaneAndAboutAnAxisIsThatOfSpace) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, 2> g = random_matrix<2>(), a = random_matrix<2>();
    const double hoop = random_matrix<2>()(0, 0), of_hoop = random_matrix<2>()(0, 0);
    const AxialMatrix<double> around{g, hoop};
    const FiniteBranchStress term;
    const auto plane = term.residual(strained<2>(g, symmetric(whole(a, 0)))).momentum_flux;
    const auto in_plane = term.residual(strained<3>(whole(g, 0), symmetric(whole(a, 0)))).momentum_flux;
    const Matrix<double, 3> memory = symmetric(whole(a, of_hoop));
    const auto axial = term.residual(strained<double, 2, AxialMatrix<double>>(around, memory)).momentum_flux;
    const auto about = term.residual(strained<3>(whole(g, hoop), memory)).momentum_flux;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        EXPECT_NEAR(plane(i, j), in_plane(i, j), 1e-14);
        EXPECT_NEAR(axial(i, j), about(i, j), 1e-14);
      }
    EXPECT_NEAR(axial.hoop, about(2, 2), 1e-14);
    EXPECT_NEAR(shear_square(strained<double, 2, AxialMatrix<double>>(around, memory).strain()),
                shear_square(strained<3>(whole(g, hoop), memory).strain()), 1e-13);
    EXPECT_NEAR(FiniteShearSquare{}.value(strained<double, 2, AxialMatrix<double>>(around, memory))[0],
                FiniteShearSquare{}.value(strained<3>(whole(g, hoop), memory))[0], 1e-13);
  }
}

// The first Piola-Kirchhoff stress is the derivative of dev(E - A) : dev(E - A) / 2 by Grad u.
TEST(FiniteBranches, StressIsTheDerivativeOfTheEnergy) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, 3> g = random_matrix<3>(), by = random_matrix<3>(), a = symmetric(random_matrix<3>());
    Matrix<Dual<double>, 3> moving;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) moving(i, j) = {g(i, j), by(i, j)};
    const auto dual = strained<Dual<double>, 3, Matrix<Dual<double>, 3>>(moving, a);
    const double rate = 0.5 * shear_square(dual.strain()).tangent;
    EXPECT_NEAR(rate, contract(FiniteBranchStress{}.residual(strained<3>(g, a)).momentum_flux, by), 1e-13);
    const auto of_memory = FiniteShearSquare{}.value(strained<3>(g, a))[0];
    EXPECT_NEAR(of_memory, contract(a, a) - trace(a) * trace(a) / 3, 1e-14);
  }
}

// A rotation of the strained body turns the stress and changes no energy.
TEST(FiniteBranches, FeelNoRotation) {
  const double c = std::cos(2.1), s = std::sin(2.1);
  Matrix<double, 3> turn{};
  turn(0, 0) = turn(1, 1) = c;
  turn(0, 1) = -s;
  turn(1, 0) = s;
  turn(2, 2) = 1;
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, 3> g = random_matrix<3>(), a = symmetric(random_matrix<3>());
    const Matrix<double, 3> turned = add_diagonal(product(turn, add_diagonal(g, 1.0)), -1.0);
    EXPECT_NEAR(shear_square(strained<3>(turned, a).strain()), shear_square(strained<3>(g, a).strain()), 1e-12);
    const auto before = product(turn, FiniteBranchStress{}.residual(strained<3>(g, a)).momentum_flux);
    const auto after = FiniteBranchStress{}.residual(strained<3>(turned, a)).momentum_flux;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(after(i, j), before(i, j), 1e-12);
  }
}

TEST(FiniteBranches, OfSmallStrainsAreThoseOfTheDisplacement) {
  const double small = 1e-6;
  const Matrix<double, 2> g = random_matrix<2>(), a = random_matrix<2>();
  const auto finite =
      FiniteBranchStress{}.residual(strained<2>(small * g, small * symmetric(whole(a, 0)))).momentum_flux;
  const auto linear = stress<2>(small * (g + (-1.0) * a));
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(finite(i, j), linear(i, j), 20 * small * small);
}

}  // namespace
}  // namespace softwet::branches
