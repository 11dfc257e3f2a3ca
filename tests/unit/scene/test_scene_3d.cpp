// A scene in 3D: products against differences, single against double precision, and what fluxes keep.
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

void check_product(const Case& c) {
  RandomSceneIn<3> s(c);
  const Array z = s.direction();
  const std::vector<double> difference = s.difference(z, 1e-4);
  EXPECT_LT(distance(s.product(z, Geometry::exact), difference), 1e-9);
  if (c.fluid && c.substrate) {
    EXPECT_GT(distance(s.product(z, Geometry::frozen), difference), 1e-4);
  }
  const StageOf<float> stage = single_stage(s.stage());
  const ArrayOf<float> direction("z", s.layout().size()), product("product", s.layout().size());
  const Array wide("wide", s.layout().size());
  convert(direction, z);
  s.scene.equations().product(stage, direction, product, Geometry::exact);
  convert(wide, product);
  const double rounding = distance(to_host(wide), s.product(z, Geometry::exact));
  EXPECT_LT(rounding, 2e-6);
  EXPECT_GT(rounding, 1e-9) << "this is double precision";
}

TEST(Model3D, Coupled) { check_product(small_case_in_3d(SceneKind::coupled)); }
TEST(Model3D, CoupledWithWallEnergyAndGravity) {
  Case c = small_case_in_3d(SceneKind::coupled, WallLaw::energy);
  c.fluid->gravity = {0.1, 0.2, -0.5};
  c.substrate->material = MaterialModel::neo_hookean;
  check_product(c);
}
TEST(Model3D, Rigid) { check_product(small_case_in_3d(SceneKind::rigid)); }
TEST(Model3D, SolidAlone) { check_product(small_case_in_3d(SceneKind::solid)); }

TEST(Model3D, FluxesOfMassSumToZero) {
  RandomSceneIn<3> s(small_case_in_3d(SceneKind::coupled));
  s.stage().moment_rate = 0;
  const std::vector<double> r = s.residual(s.stage());
  double sum = 0, size = 0;
  for (int i = s.layout().density_offset(); i < s.layout().potential_offset(); ++i) {
    sum += r[i];
    size += std::abs(r[i]);
  }
  EXPECT_GT(size, 1e-3);
  EXPECT_LT(std::abs(sum), 1e-14 * size);
}

}  // namespace
}  // namespace softwet::testing_tools
