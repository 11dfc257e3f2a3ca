// Line friction and hysteresis in 3D.
#include "unit/fluid/resisting.hpp"

namespace softwet::testing_tools {
namespace {

TEST(LineFriction, OfScenesIn3D) {
  for (const Scene kind : {Scene::rigid, Scene::coupled}) check_scene<3>(scene_in_space(kind, WallLaw::energy));
}

}  // namespace
}  // namespace softwet::testing_tools
