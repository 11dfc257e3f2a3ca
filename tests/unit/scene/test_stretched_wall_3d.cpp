// Walls whose energy depends on their stretch, in 3D.
#include "unit/scene/stretched_wall.hpp"

namespace softwet::testing_tools {
namespace {

TEST(StretchedWallScene, In3D) {
  Case c = with_exponent(small_case_in_3d(SceneKind::coupled, WallLaw::energy), 0.6);
  check_stretched_wall<3>(c);
  c.fluid->contact_angle = varying([](const std::array<double, 3>& x, double) { return 60 + 50 * x[0] - 20 * x[1]; });
  check_stretched_wall<3>(c);
}

}  // namespace
}  // namespace softwet::testing_tools
