// What the terms of the solid have in common: a residual that is the derivative of an energy, dissipation, objectivity.
#include <gtest/gtest.h>

#include <random>

#include "kernels/foundation/terms.hpp"
#include "kernels/solid/fibres.hpp"
#include "kernels/solid/graded.hpp"
#include "kernels/solid/kelvin_voigt.hpp"
#include "kernels/solid/surface_elasticity.hpp"
#include "kernels/solid/surface_tension.hpp"

namespace softwet::solid_terms {
namespace {

template <int D>
Matrix<double, D> random_matrix(double size) {
  static std::mt19937 random(20261126);
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix<double, D> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = uniform(random);
  return m;
}

template <int D>
Matrix<Dual<double>, D> moved(const Matrix<double, D>& g, const Matrix<double, D>& by) {
  Matrix<Dual<double>, D> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = {g(i, j), by(i, j)};
  return m;
}

/// A rotation by an angle in the plane of the first and the last axis.
template <int D>
Matrix<double, D> rotation(double angle) {
  Matrix<double, D> r{};
  for (int i = 0; i < D; ++i) r(i, i) = 1;
  r(0, 0) = r(D - 1, D - 1) = std::cos(angle);
  r(0, D - 1) = -std::sin(angle);
  r(D - 1, 0) = std::sin(angle);
  return r;
}

/// Grad u of the deformation R F.
template <int D>
Matrix<double, D> turned(const Matrix<double, D>& r, const Matrix<double, D>& g) {
  return add_diagonal(product(r, add_diagonal(g, 1.0)), -1.0);
}

/// energy(Grad u) in numbers of any type, and flux(Grad u).
template <int D, class Energy, class Flux>
void expect_derivative(const char* name, const Energy& energy, const Flux& flux) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, D> g = random_matrix<D>(0.3), by = random_matrix<D>(1);
    EXPECT_NEAR(energy(moved(g, by)).tangent, contract(flux(g), by), 1e-14) << name << ", " << D << "-D";
  }
}
template <int D, class Term>
void expect_derivative(const char* name, const Term& term) {
  expect_derivative<D>(
      name, [&](const auto& g) { return term.energy(SolidStrain<std::remove_cvref_t<decltype(g(0, 0))>, D>{g}); },
      [&](const Matrix<double, D>& g) { return term.residual(SolidStrain<double, D>{g}).momentum_flux; });
}
/// Checks the derivative of a term in the coordinates (r, z).
template <class Term>
void expect_derivative_around_axis(const char* name, const Term& term) {
  using M = AxialMatrix<double>;
  using Moved = AxialMatrix<Dual<double>>;
  for (int k = 0; k < 20; ++k) {
    const M g{random_matrix<2>(0.3), random_matrix<2>(0.3)(0, 0)}, by{random_matrix<2>(1), random_matrix<2>(1)(0, 0)};
    const Moved both{moved(g.plane, by.plane), {g.hoop, by.hoop}};
    const auto r = term.residual(SolidStrain<double, 2, M>{g});
    EXPECT_NEAR(term.energy(SolidStrain<Dual<double>, 2, Moved>{both}).tangent, contract(r.momentum_flux, by), 1e-14)
        << name;
  }
}
template <int D>
void expect_derivative_of_graded(ElasticLaw law, const Prestretch& prestretch = {}) {
  const GradedSolid term{{{law, {1.5, 0.7}, prestretch}, 2}};
  expect_derivative<D>(
      "graded",
      [&](const auto& g) {
        using N = std::remove_cvref_t<decltype(g(0, 0))>;
        return term.energy(GradedSolid::EnergyTrial<N, D>{{g}, N(0.4)});
      },
      [&](const Matrix<double, D>& g) {
        return term.residual(GradedSolid::Trial<double, D>{{{}, g}, 0.4}).momentum_flux;
      });
}

TEST(SolidTerms, ResidualIsTheDerivativeOfTheEnergy) {
  expect_derivative<2>("surface tension", SurfaceTension{0.7});
  expect_derivative<3>("surface tension", SurfaceTension{0.7});
  expect_derivative_around_axis("surface tension", SurfaceTension{0.7});
  expect_derivative<2>("surface elasticity", SurfaceElasticity{0.7, 0.4});
  expect_derivative<3>("surface elasticity", SurfaceElasticity{0.7, 0.4});
  expect_derivative_around_axis("surface elasticity", SurfaceElasticity{0.7, 0.4});
  for (double finite : {0.0, 1.0}) {
    expect_derivative<2>("fibres", Fibres{0.7, {{0.6, 0.8, 0}}, finite});
    expect_derivative<3>("fibres", Fibres{0.7, {{0.48, 0.6, 0.64}}, finite});
  }
  for (ElasticLaw law : {ElasticLaw::saint_venant_kirchhoff, ElasticLaw::hooke, ElasticLaw::neo_hookean}) {
    expect_derivative_of_graded<2>(law);
    expect_derivative_of_graded<3>(law);
    expect_derivative_of_graded<2>(law, {true, {{1.2, 0.9, 1}}, 0.1});
    expect_derivative_of_graded<3>(law, {true, {{1.2, 0.8, 0.9}}, 0.1});
  }
}

template <int D, class Term>
void expect_objective(const Term& term) {
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, D> g = random_matrix<D>(0.3), r = rotation<D>(0.3 * k);
    const double here = term.energy(SolidStrain<double, D>{g});
    EXPECT_NEAR(term.energy(SolidStrain<double, D>{turned(r, g)}), here, 1e-14);
  }
}

TEST(SolidTerms, EnergiesDoNotFeelRotations) {
  expect_objective<2>(SurfaceTension{0.7});
  expect_objective<3>(SurfaceTension{0.7});
  expect_objective<2>(SurfaceElasticity{0.7, 0.4});
  expect_objective<3>(SurfaceElasticity{0.7, 0.4});
  expect_objective<2>(Fibres{0.7, {{0.6, 0.8, 0}}});
  expect_objective<3>(Fibres{0.7, {{0.48, 0.6, 0.64}}});
}

TEST(SurfaceTension, ByHand) {
  // x' = (1.2, 0.5): a = 1.3
  const SurfaceTension term{2.6};
  const SolidStrain<double, 2> t{{{{0.2, 7}, {0.5, -3}}}};
  const auto r = term.residual(t);
  EXPECT_NEAR(r.momentum_flux(0, 0), 2.4, 1e-15);
  EXPECT_NEAR(r.momentum_flux(1, 0), 1.0, 1e-15);
  EXPECT_EQ(r.momentum_flux(0, 1), 0) << "slopes across the face do not count";
  EXPECT_NEAR(term.energy(t), 2.6 * 0.3, 1e-15);
  // A face stretched by 2 and 3: area 6, conormal forces 3 and 2 times the tension.
  const SolidStrain<double, 3> plane{{{{1, 0, 0}, {0, 2, 0}, {0, 0, 0}}}};
  const auto s = term.residual(plane);
  EXPECT_NEAR(s.momentum_flux(0, 0), 3 * 2.6, 1e-14);
  EXPECT_NEAR(s.momentum_flux(1, 1), 2 * 2.6, 1e-14);
  EXPECT_NEAR(term.energy(plane), 5 * 2.6, 1e-14);
}

TEST(SurfaceElasticity, ByHand) {
  const SurfaceElasticity term{0.5, 0.75};
  // x' = (1.2, 0.5): E = 0.345, S = 2 E
  const SolidStrain<double, 2> t{{{{0.2, 7}, {0.5, -3}}}};
  const auto r = term.residual(t);
  EXPECT_NEAR(r.momentum_flux(0, 0), 0.69 * 1.2, 1e-15);
  EXPECT_NEAR(r.momentum_flux(1, 0), 0.69 * 0.5, 1e-15);
  EXPECT_EQ(r.momentum_flux(0, 1), 0) << "slopes across the face do not count";
  EXPECT_NEAR(term.energy(t), 0.345 * 0.345, 1e-15);
  // Stretches 2 and 3: E = 1.5 and 4, S = 5 and 8.75.
  const SolidStrain<double, 3> plane{{{{1, 0, 0}, {0, 2, 0}, {0, 0, 0}}}};
  EXPECT_NEAR(term.residual(plane).momentum_flux(0, 0), 10, 1e-13);
  EXPECT_NEAR(term.residual(plane).momentum_flux(1, 1), 26.25, 1e-13);
  EXPECT_NEAR(term.energy(plane), 21.25, 1e-13);
  // Simple shear by 0.4: E_12 = 0.2, E_22 = 0.08, S = ((0.04, 0.3), (0.3, 0.16)).
  const auto shear = term.residual(SolidStrain<double, 3>{{{{0, 0.4, 0}, {0, 0, 0}, {0, 0, 0}}}}).momentum_flux;
  EXPECT_NEAR(shear(0, 0), 0.04 + 0.4 * 0.3, 1e-15);
  EXPECT_NEAR(shear(0, 1), 0.3 + 0.4 * 0.16, 1e-15);
  EXPECT_NEAR(shear(1, 0), 0.3, 1e-15);
  EXPECT_NEAR(shear(1, 1), 0.16, 1e-15);
}

// A stretch along r and about the axis equals the stretch of a face in 3D along two axes.
TEST(SurfaceElasticity, AroundAnAxisIsThatOfTwoAxes) {
  const SurfaceElasticity term{0.5, 0.75};
  const SolidStrain<double, 2, AxialMatrix<double>> around{{{{{0.3, 7}, {0.2, -3}}}, -0.1}};
  const SolidStrain<double, 3> plane{{{{0.3, 0, 7}, {0, -0.1, 0}, {0.2, 0, -3}}}};
  const auto r = term.residual(around).momentum_flux;
  const auto s = term.residual(plane).momentum_flux;
  EXPECT_NEAR(r(0, 0), s(0, 0), 1e-15);
  EXPECT_NEAR(r(1, 0), s(2, 0), 1e-15);
  EXPECT_NEAR(r.hoop, s(1, 1), 1e-15);
  EXPECT_NEAR(term.energy(around), term.energy(plane), 1e-15);
}

// The forces of springs on 1 x 1 of the bottom are the slopes of their energy: 2 along the face, 5 across it.
template <int D>
void expect_springs() {
  const Foundation term{5, 2};
  Vector<double, D> u;
  for (int i = 0; i < D; ++i) u[i] = 0.3 - 0.7 * i;
  const Vector<double, D> force = term.residual(SolidDisplacement<double, D>{u}).value;
  for (int i = 0; i < D; ++i) {
    EXPECT_NEAR(force[i], (i == D - 1 ? 5 : 2) * u[i], 1e-15);
    Vector<Dual<double>, D> moved;
    for (int j = 0; j < D; ++j) moved[j] = {u[j], i == j ? 1.0 : 0.0};
    EXPECT_NEAR(term.energy(SolidDisplacement<Dual<double>, D>{moved}).tangent, force[i], 1e-15);
  }
}
TEST(Foundation, ForcesAreTheSlopesOfItsEnergy) {
  expect_springs<2>();
  expect_springs<3>();
  EXPECT_NEAR((Foundation{5, 2}.energy(SolidDisplacement<double, 2>{{{0.3, -0.4}}})), 0.09 + 0.4, 1e-15);
}

// Dashpots: 5 across the face, 2 along it; their power is the product of force and velocity.
template <int D>
void expect_dashpots() {
  const Dashpots term{5, 2};
  SolidVelocity<double, D> t;
  double power = 0;
  for (int i = 0; i < D; ++i) t.vector[i] = 0.3 - 0.7 * i;
  const Vector<double, D> force = term.residual(t).value;
  for (int i = 0; i < D; ++i) {
    EXPECT_NEAR(force[i], (i == D - 1 ? 5 : 2) * t.vector[i], 1e-15);
    power += force[i] * t.vector[i];
  }
  EXPECT_NEAR(term.dissipation(t), power, 1e-15);
  EXPECT_GT(power, 0);
}
TEST(Dashpots, TakeTheProductOfForceAndVelocity) {
  expect_dashpots<2>();
  expect_dashpots<3>();
}

TEST(Fibres, UniaxialStretchByHand) {
  const Fibres term{0.5, {{1, 0, 0}}};
  const SolidStrain<double, 2> t{{{{0.2, 0}, {0, -0.1}}}};
  EXPECT_NEAR(term.residual(t).momentum_flux(0, 0), 2 * 0.5 * 0.44 * 1.2, 1e-15);
  EXPECT_NEAR(term.residual(t).momentum_flux(1, 1), 0, 1e-15);
}

template <int D>
void expect_dissipation() {
  const KelvinVoigt term{0.8, 0.3};
  for (int k = 0; k < 20; ++k) {
    const Matrix<double, D> g = random_matrix<D>(0.4), rate = random_matrix<D>(1), r = rotation<D>(0.3 * k);
    const SolidStrainRate<double, D> t{g, rate};
    const double lost = term.dissipation(t);
    EXPECT_GT(lost, 0);
    EXPECT_NEAR(contract(term.residual(t).momentum_flux, rate), lost, 1e-13) << "the power of the stress";
    // A body that turns with the rate W has Grad v = W F.
    const Matrix<double, D> f = add_diagonal(g, 1.0), w = random_matrix<D>(1);
    const Matrix<double, D> spin = 0.5 * (w + -1.0 * transpose(w));
    EXPECT_NEAR(term.dissipation(SolidStrainRate<double, D>{g, product(spin, f)}), 0, 1e-28);
    EXPECT_NEAR(term.dissipation(SolidStrainRate<double, D>{turned(r, g), product(r, rate)}), lost, 1e-13);
  }
}

TEST(KelvinVoigt, DissipatesAndIsObjective) {
  expect_dissipation<2>();
  expect_dissipation<3>();
}

TEST(KelvinVoigt, SmallStrainByHand) {
  const KelvinVoigt term{0.8, 0.3, 0};
  const SolidStrainRate<double, 2> t{{{{9, 9}, {9, 9}}}, {{{1, 0.4}, {0, 0}}}};
  const auto r = term.residual(t);
  EXPECT_NEAR(r.momentum_flux(0, 0), 2 * 0.8 * (1 - 1.0 / 3) + 0.3, 1e-15);
  EXPECT_NEAR(r.momentum_flux(0, 1), 2 * 0.8 * 0.2, 1e-15);
  EXPECT_NEAR(r.momentum_flux(1, 1), -2 * 0.8 / 3 + 0.3, 1e-15);
}

}  // namespace
}  // namespace softwet::solid_terms
