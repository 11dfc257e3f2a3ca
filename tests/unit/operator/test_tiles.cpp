// The tiles of a device in 2D, computed on the host. Element counts are no multiples of a tile.
#include "cli/core/kernel_counts.hpp"
#include "kernels/fluid/explicit_terms.hpp"
#include "mixed_channels.hpp"
#include "tile_cases.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Tiles2D, Fluid) {
  for (int along : {23, 7, 5}) {
    const TileCases<2> c(std::array<int, 2>{along, 21});
    c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
    c.check<WallMotion<2>>("density_moment", DensityMoment{}, c.patch.fluid());
  }
}

TEST(Tiles2D, Wall) {
  const TileCases<2> c(std::array<int, 2>{23, 7});
  c.check<WallMotion<2>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check_fluid("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<WallMotion<2>>("capillary_traction", c.terms.traction, c.patch.layer());
}

TEST(Tiles2D, Solid) {
  const TileCases<2> c(std::array<int, 2>{9, 7});
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

/// Numbers at points of several passes and tiles, of which the last ones are cut.
TEST(Tiles2D, PointsThatRemember) {
  const TileCases<2> c(Patch<2>({23, 9}, 5, 2, 0.6).with_point_memory(3));
  c.check<NoMotion>("branches", FiniteBranchStress{}, c.patch.solid());
  c.check_single<NoMotion>("branches", FiniteBranchStress{}, c.patch.solid());
  const TileCases<2> around(Patch<2>({23, 9}, 5, 2, 0.6).with_point_memory(4));
  around.check<NoMotion>("branches around an axis", Axisymmetric<FiniteBranchStress>{}, around.patch.solid());
  if (!has_reduced_quadrature) return;
  Patch<2> few = Patch<2>({23, 9}, 5, 2, 0.6);
  few.points = 2;
  const TileCases<2> reduced(few.with_point_memory(3));
  reduced.check<NoMotion>("branches, reduced", FiniteBranchStress{}, reduced.patch.solid());
}

TEST(Tiles2D, GradedElements) {
  const TileCases<2> c(Patch<2>({23, 9}, 3, 2, 0.6));
  c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check_fluid("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<WallMotion<2>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check<WallMotion<2>>("capillary_traction", c.terms.traction, c.patch.layer());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
  c.check<NoMotion>("surface tension", SurfaceTension{0.6}, c.patch.top());
  c.check_single<WallMotion<2, float>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}

TEST(Tiles2D, GivenFieldsAndFaces) {
  const TileCases<2> c(std::array<int, 2>{23, 7});
  const EnergyWall of_one{0.4, 1, 1e-2, c.terms.gas, c.terms.state};
  c.check<NoMotion>("graded solid", GradedSolid{{{ElasticLaw::neo_hookean, {0.8, 0.5}}, 1.3}}, c.patch.solid());
  const Prestretch before{true, {{1.2, 0.9, 1}}, 0.1};
  c.check<NoMotion>("stretched solid", GradedSolid{{{ElasticLaw::neo_hookean, {0.8, 0.5}, before}, 1.3}},
                    c.patch.solid());
  const SolidOfMeans of_means{{{{ElasticLaw::neo_hookean, {0.8, 0.5}, before}}}};
  c.check<NoMotion>("solid, means of elements", of_means, c.patch.means());
  c.check_single<NoMotion>("solid, means of elements", of_means, c.patch.means());
  c.check<NoMotion>("viscosity", KelvinVoigt{0.4, 0.3}, c.patch.solid());
  c.check<NoMotion>("surface tension", SurfaceTension{0.6}, c.patch.top());
  c.check<NoMotion>("foundation", Foundation{0.6, 0.4}, c.patch.bottom());
  c.check<NoMotion>("dashpots", Dashpots{0.6, 0.4}, c.patch.bottom());
  c.check<NoMotion>("surface elasticity", SurfaceElasticity{0.6, 0.4}, c.patch.top());
  c.check<WallMotion<2>>("painted energy_wall", PaintedWall<EnergyWall>{of_one}, c.patch.face());
  const WallTension tension{WallEnergy::of(of_one)};
  c.check<WallMotion<2>>("wall_tension", tension, c.patch.face());
  c.check<WallMotion<2>>("stretched wall_tension", StretchedWall<WallTension>{tension, 0.7, 0.3}, c.patch.face());
  c.check<WallMotion<2>>("stretched energy_wall", StretchedWall<PaintedWall<EnergyWall>>{{of_one}, 0.7},
                         c.patch.face());
}

/// Test functions that all elements above each other share.
TEST(Tiles2D, BlendedTraction) {
  const TileCases<2> c(std::array<int, 2>{9, 7});
  Region<2> r = c.patch.fluid();
  r.test = linear_from(r.test, c.patch.layout.wall_row, c.patch.blend.low, c.patch.blend.height);
  r.shared_test = true;
  c.check<WallMotion<2>>("capillary_traction", c.terms.traction, r);
}

/// Fewer points than degree + 1: slopes are swept. Element counts are no multiples of a tile, and others are less than
/// one.
class ReducedTiles2D : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  }
  static TileCases<2> cases(Patch<2> patch) {
    patch.points = 2;
    TileCases<2> c(patch);
    c.limit = 1e-13;
    return c;
  }
};

TEST_F(ReducedTiles2D, Fluid) {
  for (int along : {67, 32, 5}) {
    const TileCases<2> c = cases(Patch<2>({along, 11}, 2));
    c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
    c.check<WallMotion<2>>("density_moment", DensityMoment{}, c.patch.fluid());
  }
  const TileCases<2> c = cases(Patch<2>({35, 7}, 2));
  c.check_single<WallMotion<2, float>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  const Axisymmetric<NavierStokesKorteweg> around{c.terms.fluid};
  c.check<WallMotion<2>>("around an axis", around, c.patch.fluid());
}

/// Terms of explicit steps: one has fluxes in some channels alone, and one none at all.
TEST_F(ReducedTiles2D, ExplicitSteps) {
  const TileCases<2> c = cases(Patch<2>({35, 9}, 2, 2, 0.6));
  c.check_explicit("pressure", PressureForce{c.terms.fluid}, c.patch.fluid());
  c.check_explicit("convection", ConvectionViscosity{0.3, 0.05}, c.patch.fluid());
  c.check_explicit("flux of mass", MassFlux{}, c.patch.fluid());
  c.check_explicit("potential", VariationalDerivative{c.terms.gas, 0.4}, c.patch.fluid());
  c.check_explicit("channels of two kinds", MixedChannels{}, c.patch.fluid());
}

TEST_F(ReducedTiles2D, GradedElements) {
  const TileCases<2> c = cases(Patch<2>({37, 9}, 3, 2, 0.6));
  c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check_fluid("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<WallMotion<2>>("energy_wall", c.terms.energy_wall, c.patch.face());
  c.check<WallMotion<2>>("capillary_traction", c.terms.traction, c.patch.layer());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
  c.check<NoMotion>("surface tension", SurfaceTension{0.6}, c.patch.top());
  c.check<NoMotion>("dashpots", Dashpots{0.6, 0.4}, c.patch.bottom());
  Region<2> r = c.patch.fluid();  // test functions that all elements above each other share
  r.test = linear_from(r.test, c.patch.layout.wall_row, c.patch.blend.low, c.patch.blend.height);
  r.shared_test = true;
  c.check<WallMotion<2>>("blended capillary_traction", c.terms.traction, r);
}

TEST_F(ReducedTiles2D, PeriodicAxis) {
  Layout<2> l;
  l.solid_elements = 3;
  l.axis = {Axis(0.9, 37, 2, AxisKind::periodic), Axis(0.8, 8, 2, AxisKind::bounded, 3)};
  l.row_size = l.axis[0].functions();
  l.rows = l.axis[1].functions();
  l.wall_row = l.axis[1].span(3);
  const TileCases<2> c = cases(Patch<2>(l, {l.axis[1].lower(3), 0.8 - l.axis[1].lower(3)}));
  c.check_fluid("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

/// Means over elements: their slopes are swept with any number of points.
TEST_F(ReducedTiles2D, MeansOverElements) {
  const Prestretch before{true, {{1.2, 0.9, 1}}, 0.1};
  const SolidOfMeans of_means{{{{ElasticLaw::neo_hookean, {0.8, 0.5}, before}}}};
  const TileCases<2> c = cases(Patch<2>({37, 9}, 5, 2, 0.6));
  c.check<NoMotion>("two points", of_means, c.patch.means());
  c.check_single<NoMotion>("two points", of_means, c.patch.means());
}

TEST_F(ReducedTiles2D, DegreeThree) {
  Patch<2> patch({35, 9}, 2, 3, 0.6);
  patch.points = 3;
  TileCases<2, 3> c(patch);
  c.limit = 1e-12;
  c.check<WallMotion<2>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

TEST(Tiles2D, DegreeThree) {
  const TileCases<2, 3> c(std::array<int, 2>{11, 13});
  c.check<WallMotion<2>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}

TEST(Tiles2D, SinglePrecision) {
  const TileCases<2> c(std::array<int, 2>{9, 7});
  c.check_single<WallMotion<2, float>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}

/// Terms of one list share a launch. What one evaluation has summed does not come back in the next.
void check_several_terms(const TileCases<2>& c) {
  const Array first("first", c.patch.layout.size()), again("again", c.patch.layout.size());
  const Evaluation<2> at{c.patch.layout, c.patch.stage, c.direction, {}};
  const auto fluid = c.task<true, WallMotion<2>>(c.terms.fluid, at, c.patch.fluid());
  const auto wall = c.task<true, WallMotion<2>>(c.terms.gradient_wall, at, c.patch.face());
  const auto traction = c.task<true, WallMotion<2>>(c.terms.traction, at, c.patch.layer());
  const auto solid = c.task<true, NoMotion>(c.terms.solid, at, c.patch.solid());
  TileSums<2, double> sums(c.patch.layout, c.direction);
  KernelCounter counter;
  assemble_in_tiles<2, true, SoftTerms<2, double>>(solid, sums);
  assemble_in_tiles<2, true, SoftTerms<2, double>>(fluid, sums);
  assemble_in_tiles<2, true, SoftTerms<2, double>>(wall, sums);
  assemble_in_tiles<2, true, SoftTerms<2, double>>(traction, sums);
  sums.add_to(first);
  EXPECT_EQ(counter.stop().kernels, 2);
  assemble_in_tiles<2, true>(solid, sums);  // each with a kernel of its own
  sums.add_to(again);
  assemble_in_tiles<2, true>(fluid, sums);
  assemble_in_tiles<2, true>(traction, sums);
  assemble_in_tiles<2, true>(wall, sums);
  sums.add_to(again);
  EXPECT_LT(distance(to_host(again), to_host(first)), 1e-14);
}
TEST(Tiles2D, SeveralTermsAtOnce) { check_several_terms(TileCases<2>(std::array<int, 2>{9, 7})); }

/// A product with another vector copies nothing to the device but its numbers.
TEST(Tiles2D, TermsAreCopiedOnce) {
  const TileCases<2> c(std::array<int, 2>{9, 7});
  const Array twice("twice", c.direction.extent(0)), out("out", c.patch.layout.size());
  const Array of_twice("of_twice", out.extent(0));
  combine(twice, 2, c.direction, 0);
  const Region<2> region = c.patch.fluid();
  const auto product = [&](const Array& z, const Array& to) {
    const Evaluation<2> at{c.patch.layout, c.patch.stage, z, {}};
    TileSums<2, double> sums(c.patch.layout, z);
    assemble_in_tiles<2, true>(c.task<true, WallMotion<2>>(c.terms.fluid, at, region), sums);
    sums.store(to, {});
  };
  product(c.direction, out);
  const long copies = copies_of_bytes();
  product(twice, of_twice);
  EXPECT_EQ(copies_of_bytes(), copies);
  add_scaled(of_twice, 0, -2, out);
  EXPECT_LT(largest(to_host(of_twice)), 1e-12 * largest(to_host(out)));
}

TEST(Tiles2D, ThreadsOfATeam) {
  const TileCases<2> c(std::array<int, 2>{9, 19});
  c.check_threads<true, WallMotion<2>>(c.terms.fluid, c.patch.fluid());
  c.check_threads<true, NoMotion>(c.terms.solid, c.patch.solid());
}

TEST_F(ReducedTiles2D, SeveralTermsAtOnce) { check_several_terms(cases(Patch<2>({9, 7}, 2))); }

TEST_F(ReducedTiles2D, ThreadsOfATeam) {
  const TileCases<2> c = cases(Patch<2>({35, 7}, 2));
  c.check_threads<true, WallMotion<2>, 2>(c.terms.fluid, c.patch.fluid());
  c.check_threads<false, WallMotion<2>, 2>(c.terms.energy_wall, c.patch.face());
}

/// As on a device: a thread for each point, or for two of them.
TEST_F(ReducedTiles2D, AsManyThreadsAsADevice) {
  const TileCases<2> c = cases(Patch<2>({35, 7}, 2, 2, 0.6));
  constexpr int points = SlopeTileShape<2, 2, 2>::points;
  c.check_threads<false, WallMotion<2>, 2, points>(c.terms.fluid, c.patch.fluid());
  c.check_threads<false, NoMotion, 2, points / 2>(PressureForce{c.terms.fluid}, c.patch.fluid());
}

}  // namespace
}  // namespace softwet::testing_tools
