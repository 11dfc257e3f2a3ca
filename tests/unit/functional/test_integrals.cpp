// Integrands of the functionals at a point, by hand.
#include <gtest/gtest.h>

#include "kernels/functional/fluid_integrals.hpp"
#include "kernels/functional/liquid_volume.hpp"
#include "kernels/functional/solid_integrals.hpp"
#include "kernels/functional/term_integrals.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {
namespace {

TEST(FluidIntegrals, ByHand) {
  const FluidIntegrals f{{{0.81, 0}, 3.0, 0.5, 0.1, 0.01}, {0.25, 1.25}};
  FluidTrial<double, 2> t{};
  t.velocity = {{2, 3}};
  t.velocity_gradient = {{{1, 2}, {3, 5}}};
  t.density = 0.5;
  t.density_gradient = {{0.1, -0.2}};
  t.chemical_potential_gradient = {{4, -8}};
  const auto v = f.value(t);
  EXPECT_EQ(v[FluidIntegrals::mass], 0.5);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::kinetic], 0.25 * 13);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::bulk], -0.25);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::gradient], 0.125 * 0.05);
  // tau = 3 [[2, 5], [5, 10]] - 12 I; tau : grad v = -6 + 30 + 45 + 90.
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::viscous], 159);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::stabilisation], 0.1 * 0.25 * 80);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::momentum], 1);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::momentum + 1], 1.5);
  EXPECT_EQ(v[FluidIntegrals::momentum + 2], 0);
  EXPECT_DOUBLE_EQ(v[FluidIntegrals::liquid], 0.15625) << "a quarter of the way: 1/16 (3 - 1/2)";
}

TEST(FluidContents, ByHand) {
  const FluidContents f;
  const auto v = f.value(FilledMesh<double, 2>{{0.5}, 1});
  EXPECT_EQ(v[FluidContents::mass], 0.5);
  EXPECT_EQ(v[FluidContents::volume], 1);
  EXPECT_EQ(v[FluidContents::folded], 0);
  EXPECT_EQ(f.value(FilledMesh<double, 2>{{0.5}, -0.1})[FluidContents::folded], -1) << "times J: a positive volume";
}

TEST(LiquidVolume, ByHand) {
  const LiquidVolume f{0.25, 0.75};
  const auto at = [&](double density) { return f.of(density); };
  EXPECT_EQ(at(0.25), 0);
  EXPECT_EQ(at(0.75), 1);
  EXPECT_EQ(at(0.5), 0.5);
  EXPECT_DOUBLE_EQ(at(0.375), 0.15625) << "a quarter of the way: 1/16 (3 - 1/2)";
  EXPECT_DOUBLE_EQ(at(0.625), 0.84375);
  EXPECT_EQ(at(0.2), 0) << "thinner than the vapour";
  EXPECT_EQ(at(0.8), 1) << "denser than the liquid";
}

TEST(SolidMotion, ByHand) {
  const SolidMotion f{2.0};
  const auto v = f.value(SolidVelocity<double, 3>{{{1, 2, -2}}});
  EXPECT_EQ(v[SolidMotion::kinetic], 9);
  EXPECT_EQ(v[SolidMotion::momentum + 2], -4);
}

TEST(EnergyOf, ElasticByHand) {
  const EnergyOf<Elastodynamics<SaintVenantKirchhoff>> f{{{{1.5, 0.7}}, 2.0}};
  const auto v = f.value(SolidStrain<double, 3>{{{{0.2, 0, 0}, {0, 0, 0}, {0, 0, 0}}}});
  EXPECT_NEAR(v[0], (0.75 + 0.7) * 0.22 * 0.22, 1e-16);
}

TEST(InvertedSolid, WhereTheDeterminantIsNotPositive) {
  const InvertedSolid f;
  EXPECT_EQ(f.value(SolidStrain<double, 3>{{{{0.2, 0, 0}, {0, 0, 0}, {0, 0, 0}}}})[0], 0);
  EXPECT_EQ(f.value(SolidStrain<double, 3>{{{{-2, 0, 0}, {0, 0, 0}, {0, 0, 0}}}})[0], 1) << "det F = -1";
}

}  // namespace
}  // namespace softwet
