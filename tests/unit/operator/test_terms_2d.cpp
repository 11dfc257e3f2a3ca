// Every term in 2D: residual against the reference assembly, exact product against differences.
#include "term_cases.hpp"

namespace softwet::testing_tools {
namespace {

TermCases<2> cases() { return TermCases<2>(std::array<int, 2>{11, 7}); }

TEST(Terms2D, FluidOnMovingMesh) { cases().check_fluid<WallMotion>(); }
TEST(Terms2D, FluidOnFixedMesh) { cases().check_fluid<Still>(); }
TEST(Terms2D, WallOnMovingMesh) { cases().check_wall<WallMotion>(); }
TEST(Terms2D, WallOnFixedMesh) { cases().check_wall<Still>(); }
TEST(Terms2D, Solid) { cases().check_solid(); }

/// The host computes columns in blocks of 8 elements.
TEST(Terms2D, ColumnsOfSeveralBlocks) { TermCases<2>(std::array<int, 2>{5, 21}).check_fluid<WallMotion>(); }

TermCases<2> reduced() {
  TermCases<2> c = cases();
  c.patch.points = 2;
  return c;
}

using Reduced2D = ReducedQuadrature;
TEST_F(Reduced2D, FluidOnMovingMesh) { reduced().check_fluid<WallMotion>(); }
TEST_F(Reduced2D, FluidOnFixedMesh) { reduced().check_fluid<Still>(); }
TEST_F(Reduced2D, WallOnMovingMesh) { reduced().check_wall<WallMotion>(); }
TEST_F(Reduced2D, WallOnFixedMesh) { reduced().check_wall<Still>(); }
TEST_F(Reduced2D, Solid) { reduced().check_solid(); }

}  // namespace
}  // namespace softwet::testing_tools
