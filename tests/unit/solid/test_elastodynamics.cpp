// Momentum of the solid at a point.
#include "kernels/solid/elastodynamics.hpp"

#include <gtest/gtest.h>

#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {
namespace {

TEST(Elastodynamics, InertiaAndStress) {
  const Elastodynamics<SaintVenantKirchhoff> term{{{1.5, 0.7}}, 2.0};
  const SolidTrial<double, 2> t{{{3, -5}}, {{{0.2, 0}, {0, 0}}}};
  const auto r = term.residual(t);
  EXPECT_DOUBLE_EQ(r.momentum[0], 6);
  EXPECT_DOUBLE_EQ(r.momentum[1], -10);
  EXPECT_NEAR(r.momentum_flux(0, 0), 1.2 * 2.9 * 0.22, 1e-15);  // s (lambda + 2 G) (s^2 - 1)/2
  EXPECT_NEAR(r.momentum_flux(1, 1), 1.5 * 0.22, 1e-15);
}

TEST(Elastodynamics, TangentAgainstDifferences) {
  const Elastodynamics<SaintVenantKirchhoff> term{{{1.5, 0.7}}, 2.0};
  SolidTrial<Dual<double>, 3> t;
  SolidTrial<double, 3> base, step;
  for (int i = 0; i < 3; ++i) {
    base.acceleration[i] = std::sin(i + 1.0);
    step.acceleration[i] = std::cos(2.0 * i);
    t.acceleration[i] = {base.acceleration[i], step.acceleration[i]};
    for (int j = 0; j < 3; ++j) {
      base.displacement_gradient(i, j) = 0.3 * std::sin(3.0 * i + j);
      step.displacement_gradient(i, j) = std::cos(i + 5.0 * j);
      t.displacement_gradient(i, j) = {base.displacement_gradient(i, j), step.displacement_gradient(i, j)};
    }
  }
  const auto exact = term.residual(t);
  const auto at = [&](double e) {
    SolidTrial<double, 3> s = base;
    s.acceleration = s.acceleration + e * step.acceleration;
    s.displacement_gradient = s.displacement_gradient + e * step.displacement_gradient;
    return term.residual(s);
  };
  const double e = 1e-3;
  const auto a = at(e), b = at(-e), c = at(2 * e), d = at(-2 * e);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(exact.momentum[i].tangent, 2 * step.acceleration[i], 1e-14);
    for (int j = 0; j < 3; ++j) {
      const double slope =
          (8 * (a.momentum_flux(i, j) - b.momentum_flux(i, j)) - c.momentum_flux(i, j) + d.momentum_flux(i, j)) /
          (12 * e);
      EXPECT_NEAR(exact.momentum_flux(i, j).tangent, slope, 1e-11);
    }
  }
}

}  // namespace
}  // namespace softwet
