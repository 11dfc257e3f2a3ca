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

}  // namespace
}  // namespace softwet::branches
