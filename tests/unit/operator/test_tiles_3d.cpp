// The tiles of a device in 3D, computed on the host.
#include "cli/core/kernel_counts.hpp"
#include "kernels/fluid/explicit_terms.hpp"
#include "mixed_channels.hpp"
#include "tile_cases.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Tiles3D, Fluid) {
  const TileCases<3> c(std::array<int, 3>{7, 5, 9});
  c.check<WallMotion<3>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}

TEST(Tiles3D, Wall) {
  const TileCases<3> c(std::array<int, 3>{5, 6, 4});
  c.check<WallMotion<3>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check<WallMotion<3>>("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<WallMotion<3>>("capillary_traction", c.terms.traction, c.patch.layer());
}

TEST(Tiles3D, Solid) {
  const TileCases<3> c(std::array<int, 3>{4, 3, 5});
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

/// Numbers at points of several passes and tiles, of which the last ones are cut.
TEST(Tiles3D, PointsThatRemember) {
  const TileCases<3> c(Patch<3>({7, 5, 9}, 5, 2, 0.6).with_point_memory(6));
  c.check<NoMotion>("branches", FiniteBranchStress{}, c.patch.solid());
  c.check_single<NoMotion>("branches", FiniteBranchStress{}, c.patch.solid());
  if (!has_reduced_quadrature) return;
  Patch<3> few = Patch<3>({7, 5, 9}, 5, 2, 0.6);
  few.points = 2;
  const TileCases<3> reduced(few.with_point_memory(6));
  reduced.check<NoMotion>("branches, reduced", FiniteBranchStress{}, reduced.patch.solid());
}

TEST(Tiles3D, GradedElements) {
  const TileCases<3> c(Patch<3>({7, 5, 6}, 2, 2, 0.6));
  c.check<WallMotion<3>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check<WallMotion<3>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

/// Fewer points than degree + 1: slopes are swept. Graded elements, and counts that are no multiples of a tile.
class ReducedTiles3D : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  }
  static TileCases<3> cases(const std::array<int, 3>& elements, double uneven = 0) {
    Patch<3> patch(elements, 2, 2, uneven);
    patch.points = 2;
    TileCases<3> c(patch);
    c.limit = 1e-13;
    return c;
  }
};

TEST_F(ReducedTiles3D, Fluid) {
  const TileCases<3> c = cases({9, 5, 8});
  c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check_single<WallMotion<3, float>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}

TEST_F(ReducedTiles3D, GradedElements) {
  const TileCases<3> c = cases({6, 3, 7}, 0.6);
  c.check<WallMotion<3>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check_fluid("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<WallMotion<3>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check<WallMotion<3>>("capillary_traction", c.terms.traction, c.patch.layer());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

/// Terms of explicit steps: channels have integrands against values, fluxes, or both.
TEST_F(ReducedTiles3D, ExplicitSteps) {
  const TileCases<3> c = cases({6, 5, 7}, 0.6);
  c.check_explicit("pressure", PressureForce{c.terms.fluid}, c.patch.fluid());
  c.check_explicit("convection", ConvectionViscosity{0.3, 0.05}, c.patch.fluid());
  c.check_explicit("flux of mass", MassFlux{}, c.patch.fluid());
  c.check_explicit("potential", VariationalDerivative{c.terms.gas, 0.4}, c.patch.fluid());
  c.check_explicit("channels of two kinds", MixedChannels{}, c.patch.fluid());
}

TEST_F(ReducedTiles3D, ThreadsOfATeam) {
  const TileCases<3> c = cases({5, 3, 7});
  c.check_threads<false, WallMotion<3>, 2>(c.terms.fluid, c.patch.fluid());
}

/// As on a device: a thread for two points, or for each, and short lists that other warps take.
TEST_F(ReducedTiles3D, AsManyThreadsAsADevice) {
  const TileCases<3> c = cases({5, 3, 7}, 0.6);
  constexpr int points = SlopeTileShape<3, 2, 2>::points;
  c.check_threads<false, WallMotion<3>, 2, points>(c.terms.fluid, c.patch.fluid());
  c.check_threads<true, WallMotion<3>, 2, points>(c.terms.gradient_wall, c.patch.face());
  c.check_threads<false, WallMotion<3>, 2, points / 2>(ConvectionViscosity{0.3, 0.05}, c.patch.fluid());
  c.check_threads<false, NoMotion, 2, points / 2>(PressureForce{c.terms.fluid}, c.patch.fluid());
  c.check_threads<false, WallMotion<3>, 2, points / 2>(MassFlux{}, c.patch.fluid());
}

/// A product has two launches, as in 2D: the tiles of all terms, and what collects them.
TEST(Tiles3D, SeveralTermsAtOnce) {
  const TileCases<3> c(std::array<int, 3>{4, 3, 5});
  const Evaluation<3> at{c.patch.layout, c.patch.stage, c.direction, {}};
  const auto fluid = c.task<true, WallMotion<3>>(c.terms.fluid, at, c.patch.fluid());
  const auto wall = c.task<true, WallMotion<3>>(c.terms.gradient_wall, at, c.patch.face());
  const auto solid = c.task<true, NoMotion>(c.terms.solid, at, c.patch.solid());
  const Array together("together", c.patch.layout.size()), alone("alone", c.patch.layout.size());
  TileSums<3, double> sums(c.patch.layout, c.direction);
  KernelCounter counter;
  assemble_in_tiles<2, true, SoftTerms<3, double>>(solid, sums);
  assemble_in_tiles<2, true, SoftTerms<3, double>>(fluid, sums);
  assemble_in_tiles<2, true, SoftTerms<3, double>>(wall, sums);
  sums.add_to(together);
  EXPECT_EQ(counter.stop().kernels, 2);
  assemble_in_tiles<2, true>(solid, sums);
  assemble_in_tiles<2, true>(fluid, sums);
  assemble_in_tiles<2, true>(wall, sums);
  sums.add_to(alone);
  EXPECT_LT(distance(to_host(together), to_host(alone)), 1e-14);
}

TEST(Tiles3D, ThreadsOfATeam) {
  const TileCases<3> c(std::array<int, 3>{4, 3, 9});
  c.check_threads<true, WallMotion<3>>(c.terms.fluid, c.patch.fluid());
}

/// As on a device: then short lists begin at other threads, and a pass begins before the last one has been added up.
TEST(Tiles3D, AsManyThreadsAsPoints) {
  const TileCases<3> c(std::array<int, 3>{4, 3, 9});
  constexpr int threads = ChosenTile<3, 2, false, double>::points;
  c.check_threads<false, WallMotion<3>, 3, threads>(c.terms.fluid, c.patch.fluid());
  c.check_threads<true, WallMotion<3>, 3, threads>(c.terms.gradient_wall, c.patch.face());
}

}  // namespace
}  // namespace softwet::testing_tools
