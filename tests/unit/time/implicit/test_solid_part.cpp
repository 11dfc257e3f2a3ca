// The solid's part of a Jacobian: where it is, and how it changes with the time step.
#include "time/implicit/implicit_scheme.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// Norm of the solid's rows of J z, where z is `direction` within the solid and 0 elsewhere.
double size_of_product(RandomScene& random, const std::vector<double>& direction, double rate_scale,
                       double displacement_scale) {
  Stage stage = random.stage();
  stage.rate_scale = rate_scale;
  stage.displacement_scale = displacement_scale;
  const SolidPart solid = solid_part(random.scene, stage);
  std::vector<double> z(random.layout().size(), 0.0);
  for (const SolidPart::Range& r : solid.ranges)
    for (int i = r.first; i < r.last - random.layout().row_size; ++i) z[i] = direction[i];  // without the wall
  const Array out("out", random.layout().size());
  random.scene.equations().product(stage, to_device<Array>(z), out, Geometry::frozen);
  double sum = 0;
  const std::vector<double> values = to_host(out);
  for (const SolidPart::Range& r : solid.ranges)
    for (int i = r.first; i < r.last - random.layout().row_size; ++i) sum += values[i] * values[i];
  return std::sqrt(sum);
}

TEST(SolidPart, HasTheVelocitiesOfTheSolidWithThoseOfTheWall) {
  RandomScene random(small_case(SceneKind::coupled));
  const Layout<2>& l = random.layout();
  const SolidPart solid = solid_part(random.scene, random.stage());
  ASSERT_EQ(solid.ranges.size(), 2u);
  for (int d = 0; d < 2; ++d) {
    EXPECT_EQ(solid.ranges[d].first, l.component_shift(d));
    EXPECT_EQ(solid.ranges[d].last, l.component_shift(d) + (l.wall_row + 1) * l.row_size);
  }
  RandomScene rigid(small_case(SceneKind::rigid));
  EXPECT_TRUE(solid_part(rigid.scene, rigid.stage()).ranges.empty());
}

TEST(SolidPart, ItsSizeFollowsTheJacobian) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::solid}) {
    RandomScene random(small_case(kind));
    const auto size = [&](double rate_scale, double displacement_scale) {
      Stage stage = random.stage();
      stage.rate_scale = rate_scale;
      stage.displacement_scale = displacement_scale;
      return solid_part(random.scene, stage).size;
    };
    const std::vector<double> direction = to_host(random.direction());
    const auto found = [&](double rate_scale, double displacement_scale) {
      return size_of_product(random, direction, rate_scale, displacement_scale);
    };
    // Inertia alone, and stiffness alone: in proportion. From a short step to a long one: within a factor of three.
    EXPECT_NEAR(size(3, 0) / size(1, 0), found(3, 0) / found(1, 0), 1e-9);
    EXPECT_NEAR(size(0, 3) / size(0, 1), found(0, 3) / found(0, 1), 1e-9);
    const double expected = found(0.1, 10) / found(1000, 1e-3), ratio = size(0.1, 10) / size(1000, 1e-3);
    EXPECT_LT(ratio, 3 * expected);
    EXPECT_GT(ratio, expected / 3);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
