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

}  // namespace
}  // namespace softwet::testing_tools
