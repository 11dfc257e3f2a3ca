// Line friction and hysteresis in 3D.
#include "unit/fluid/resisting.hpp"

namespace softwet::testing_tools {
namespace {

TEST(LineFriction, OfScenesIn3D) {
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled})
    check_scene<3>(small_case_in_3d(kind, WallLaw::energy));
}

}  // namespace
}  // namespace softwet::testing_tools
