// Every term in 3D: residual against the reference assembly, exact product against differences.
#include "term_cases.hpp"

namespace softwet::testing_tools {
namespace {

TermCases<3> cases() { return TermCases<3>(std::array<int, 3>{9, 4, 4}); }

TEST(Terms3D, FluidOnMovingMesh) { cases().check_fluid<WallMotion>(); }
TEST(Terms3D, FluidOnFixedMesh) { cases().check_fluid<Still>(); }
TEST(Terms3D, WallOnMovingMesh) { cases().check_wall<WallMotion>(); }
TEST(Terms3D, WallOnFixedMesh) { cases().check_wall<Still>(); }
TEST(Terms3D, Solid) { cases().check_solid(); }

TermCases<3> reduced() {
  TermCases<3> c = cases();
  c.patch.points = 2;
  return c;
}

TEST(Terms3D, ReducedFluidOnMovingMesh) { reduced().check_fluid<WallMotion>(); }
TEST(Terms3D, ReducedFluidOnFixedMesh) { reduced().check_fluid<Still>(); }
TEST(Terms3D, ReducedWallOnMovingMesh) { reduced().check_wall<WallMotion>(); }
TEST(Terms3D, ReducedWallOnFixedMesh) { reduced().check_wall<Still>(); }
TEST(Terms3D, ReducedSolid) { reduced().check_solid(); }

/// The host computes columns in blocks of 8 elements.
TEST(Terms3D, ColumnsOfSeveralBlocks) { TermCases<3>(std::array<int, 3>{5, 3, 12}).check_fluid<WallMotion>(); }

}  // namespace
}  // namespace softwet::testing_tools
