// The fluid's terms at a point, by hand and by their tangents.
#include "kernels/fluid/explicit_terms.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

FluidTrial<double, 2> trial() {
  FluidTrial<double, 2> t;
  t.velocity = {{2, 3}};
  t.velocity_gradient = {{{1, 2}, {3, 5}}};
  t.acceleration = {{7, -1}};
  t.density = 0.5;
  t.density_gradient = {{0.1, -0.2}};
  t.chemical_potential = -0.6;
  t.chemical_potential_gradient = {{4, -8}};
  t.mesh_velocity = {{1, 1}};
  return t;
}

// theta = 0.81: W'(1/2) = -0.52. Slip velocity v - vh = (1, 2); (grad v) (v - vh) = (5, 13).
TEST(NavierStokesKorteweg, ByHand) {
  const NavierStokesKorteweg term{{0.81, 0}, 3.0, 0.5, 0.1, 0.01};
  const auto r = term.residual(trial());
  EXPECT_DOUBLE_EQ(r.momentum[0], 0.5 * (7 + 5) + 0.5 * 4);
  EXPECT_DOUBLE_EQ(r.momentum[1], 0.5 * (-1 + 13) - 0.5 * 8);
  EXPECT_DOUBLE_EQ(r.momentum_flux(0, 0), 3 * 2 - 2 * 6);
  EXPECT_DOUBLE_EQ(r.momentum_flux(0, 1), 15);
  EXPECT_DOUBLE_EQ(r.mass_flux[0], 0.1 * 0.25 * 4 - 0.5 * 1);
  EXPECT_DOUBLE_EQ(r.mass_flux[1], -0.1 * 0.25 * 8 - 0.5 * 2);
  EXPECT_NEAR(r.potential, -0.6 + 0.52, 1e-15);
  EXPECT_DOUBLE_EQ(r.potential_flux[0], -0.25 * 0.1);
  EXPECT_DOUBLE_EQ(r.potential_flux[1], 0.25 * 0.2);
}

// The floor acts on the inertia alone: the potential force keeps the true density, and so does the mass flux.
TEST(NavierStokesKorteweg, InertiaFloor) {
  NavierStokesKorteweg term{{0.81, 0}, 3.0, 0.5, 0.0, 0.6};
  const auto r = term.residual(trial());
  EXPECT_DOUBLE_EQ(r.momentum[0], 0.6 * (7 + 5) + 0.5 * 4);
  EXPECT_DOUBLE_EQ(r.mass_flux[0], -0.5);
}

// What explicit schemes evaluate part by part is all but the acceleration.
template <class M>
void expect_sum_of_parts(const M& velocity_gradient) {
  const NavierStokesKorteweg term{{0.81, 0}, 3.0, 0.5, 0.1, 0.6, {0.3, -0.7}};
  const FluidTrial<double, 2> plane = trial();
  const FluidTrial<double, 2, M> t{plane.velocity,
                                   velocity_gradient,
                                   {{0, 0}},
                                   plane.density,
                                   plane.density_gradient,
                                   plane.chemical_potential,
                                   plane.chemical_potential_gradient,
                                   plane.mesh_velocity};
  const auto whole = term.residual(t);
  const auto mass = MassFlux{}.residual(MassFluxTrial<double, 2>{t.velocity, t.mesh_velocity, t.density});
  const auto pressure =
      PressureForce{term}.residual(PressureTrial<double, 2>{t.density, t.chemical_potential_gradient});
  const auto rest = ConvectionViscosity{term.viscosity, term.inertia_floor}.residual(
      ConvectionTrial<double, 2, M>{t.velocity, t.mesh_velocity, t.velocity_gradient, t.density});
  for (int i = 0; i < 2; ++i) {
    EXPECT_DOUBLE_EQ(whole.momentum[i], pressure.momentum[i] + rest.momentum[i]);
    EXPECT_DOUBLE_EQ(whole.mass_flux[i], mass.mass_flux[i] + pressure.mass_flux[i]);
    for (int j = 0; j < 2; ++j) EXPECT_DOUBLE_EQ(whole.momentum_flux(i, j), rest.momentum_flux(i, j));
  }
  if constexpr (is_axial_matrix<M>) {
    EXPECT_DOUBLE_EQ(whole.momentum_flux.hoop, rest.momentum_flux.hoop);
  }
}
TEST(NavierStokesKorteweg, IsTheSumOfItsExplicitParts) {
  const Matrix<double, 2> gradient = trial().velocity_gradient;
  expect_sum_of_parts(gradient);
  expect_sum_of_parts(AxialMatrix<double>{gradient, 0.4});
}

// At rest in one phase with mu = W' nothing acts.
TEST(NavierStokesKorteweg, UniformRest) {
  const NavierStokesKorteweg term{{0.39, 0.0002}, 3.0, 0.5, 0.1, 0.01};
  FluidTrial<double, 3> t{};
  t.density = 0.3;
  t.chemical_potential = term.gas.derivative(0.3);
  const auto r = term.residual(t);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(r.momentum[i], 0);
    EXPECT_EQ(r.mass_flux[i], 0);
    for (int j = 0; j < 3; ++j) EXPECT_EQ(r.momentum_flux(i, j), 0);
  }
  EXPECT_EQ((DensityMoment{}.residual(DensityValueTrial<double, 3>{t.density}).mass), 0.3);
  EXPECT_EQ(r.potential, 0);
}

// In one phase at rest the traction is the pressure: Sigma = -p I.
TEST(CapillaryTraction, UniformStateIsUnderPressure) {
  const CapillaryTraction term{{0.39, 0.0}, 0.5};
  TractionTrial<double, 2> t{};
  t.density = 0.8;
  t.chemical_potential = term.gas.derivative(0.8);
  const auto r = term.residual(t);
  EXPECT_NEAR(r.momentum_flux(0, 0), -term.gas.pressure(0.8), 1e-15);
  EXPECT_NEAR(r.momentum_flux(1, 1), -term.gas.pressure(0.8), 1e-15);
  EXPECT_EQ(r.momentum_flux(0, 1), 0);
  EXPECT_EQ(r.momentum[0], 0);
}

// The force cancels the fluid's own (w, rho grad mu) for the wall's functions.
TEST(CapillaryTraction, CancelsThePotentialForce) {
  const CapillaryTraction term{{0.81, 0.0}, 0.5};
  const auto r = term.residual(TractionTrial<double, 2>{0.5, {{0.1, -0.2}}, -0.6, {{4, -8}}});
  EXPECT_DOUBLE_EQ(r.momentum[0], -2);
  EXPECT_DOUBLE_EQ(r.momentum[1], 4);
  // W(1/2) = -1/4; -rho mu = 0.3; g^2 |grad rho|^2 / 2 = 0.00625.
  EXPECT_NEAR(r.momentum_flux(0, 0), -0.25 + 0.3 + 0.00625 - 0.25 * 0.01, 1e-15);
  EXPECT_NEAR(r.momentum_flux(0, 1), 0.25 * 0.02, 1e-15);
}

}  // namespace
}  // namespace softwet
