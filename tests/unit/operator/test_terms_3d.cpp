// Every term in 3D: residual against the reference assembly, exact product against differences.
#include "term_cases.hpp"

namespace softwet::testing_tools {
namespace {

TermCases<3> cases_3d() { return TermCases<3>(std::array<int, 3>{9, 4, 4}); }

TEST(Terms3D, FluidOnMovingMesh) { cases_3d().check_fluid<WallMotion>(); }
TEST(Terms3D, FluidOnFixedMesh) { cases_3d().check_fluid<Still>(); }
TEST(Terms3D, WallOnMovingMesh) { cases_3d().check_wall<WallMotion>(); }
TEST(Terms3D, WallOnFixedMesh) { cases_3d().check_wall<Still>(); }
TEST(Terms3D, Solid) { cases_3d().check_solid(); }

TermCases<3> reduced_3d() {
  TermCases<3> c = cases_3d();
  c.patch.points = 2;
  return c;
}

using Reduced3D = ReducedQuadrature;
TEST_F(Reduced3D, FluidOnMovingMesh) { reduced_3d().check_fluid<WallMotion>(); }
TEST_F(Reduced3D, FluidOnFixedMesh) { reduced_3d().check_fluid<Still>(); }
TEST_F(Reduced3D, WallOnMovingMesh) { reduced_3d().check_wall<WallMotion>(); }
TEST_F(Reduced3D, WallOnFixedMesh) { reduced_3d().check_wall<Still>(); }
TEST_F(Reduced3D, Solid) { reduced_3d().check_solid(); }

/// The host computes columns in blocks of 8 elements.
TEST(Terms3D, ColumnsOfSeveralBlocks) { TermCases<3>(std::array<int, 3>{5, 3, 12}).check_fluid<WallMotion>(); }

}  // namespace
}  // namespace softwet::testing_tools
