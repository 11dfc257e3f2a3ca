// The tiles of a device in 3D, computed on the host.
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

TEST(Tiles3D, ReducedQuadrature) {
  if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  TileCases<3> c(std::array<int, 3>{6, 3, 5});
  c.patch.points = 2;
  c.check<WallMotion<3>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
  c.check<WallMotion<3>>("gradient_wall", c.terms.gradient_wall, c.patch.face());
  c.check<NoMotion>("saint_venant_kirchhoff", c.terms.solid, c.patch.solid());
}

TEST(Tiles3D, ThreadsOfATeam) {
  const TileCases<3> c(std::array<int, 3>{4, 3, 9});
  c.check_threads<true, WallMotion<3>>(c.terms.fluid, c.patch.fluid());
}

}  // namespace
}  // namespace softwet::testing_tools
