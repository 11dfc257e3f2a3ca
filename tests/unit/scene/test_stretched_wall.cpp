// Walls whose energy depends on their stretch, in 2D and in (r, z): energy, product, prestretch, and refused cases.
#include "unit/scene/stretched_wall.hpp"

#include "case/error.hpp"
#include "scene/equilibrium.hpp"
#include "unit/io/expect_error.hpp"

namespace softwet::testing_tools {
namespace {

Case painted(Case c) {
  c.fluid->contact_angle = varying([](const std::array<double, 3>& x, double) { return 60 + 50 * x[0]; });
  return c;
}

TEST(StretchedWallScene, In2D) {
  for (const double beta : {0.3, 1.0}) {
    const Case c = with_exponent(small_case(SceneKind::coupled, WallLaw::energy), beta);
    if (beta < 1) check_stretched_wall<2>(c);
    if (beta < 1) check_stretched_wall<2>(painted(c));
    RandomScene s(c);
    if (beta == 1) check_product(s);
  }
}
TEST(StretchedWallScene, AroundAnAxis) {
  const Case c = axisymmetric(with_exponent(small_case(SceneKind::coupled, WallLaw::energy), 0.6));
  check_stretched_wall<2>(c);
  check_stretched_wall<2>(painted(c));
}

// With the exponent 1 the energy belongs to the area before, and the wall feels no tension of it.
TEST(StretchedWallScene, HasNoTensionWithTheExponentOne) {
  Case c = with_exponent(small_case(SceneKind::coupled, WallLaw::energy), 1);
  RandomScene none(c);
  c.fluid->wall_tension = WallTensionModel::acts;
  RandomScene acts(c);
  EXPECT_LT(distance(acts.residual(acts.stage()), none.residual(none.stage())), 1e-15);
  EXPECT_NEAR(none.scene.balance().measure(none.stage()).integrals["wall_stretch"], 0, 1e-14);
}

// Where nothing is displaced a wall that was stretched before has the effective angle.
TEST(StretchedWallScene, CountsFromBeforeAPrestretch) {
  for (const bool around : {false, true}) {
    Case c = with_exponent(small_case(SceneKind::coupled, WallLaw::energy), 0.6);
    if (around) c = axisymmetric(c);
    c.fluid->wall_tension = WallTensionModel::none;
    c.substrate->prestretch = {1.15};
    const double factor = std::pow(around ? 1.15 * 1.15 : 1.15, -0.6);
    EXPECT_NEAR(c.cosine_factor(), factor, 1e-15);
    RandomScene stretched(c);
    c.fluid->wall_stretch_exponent = 0;
    c.fluid->contact_angle = std::acos(factor * std::cos(60 * M_PI / 180)) * 180 / M_PI;
    RandomScene effective(c);
    Stage still = stretched.stage();
    still.displacement = still.displacement_end = Array("still", still.displacement.extent(0));
    EXPECT_LT(distance(stretched.residual(still), effective.residual(still)), 1e-13);
    EXPECT_NEAR(stretched.scene.balance().measure(still).integrals["energy_wall"],
                effective.scene.balance().measure(still).integrals["energy_wall"], 1e-14);
    EXPECT_GT(distance(stretched.residual(stretched.stage()), effective.residual(stretched.stage())), 1e-6);
  }
}

TEST(StretchedWallScene, NeedsAModulusWhereTheWallRepelsTheLiquid) {
  Case c = with_exponent(small_case(SceneKind::coupled, WallLaw::energy), 0.5);
  c.fluid->wall_tension = WallTensionModel::acts;
  c.fluid->contact_angle = 120;
  const double needed = 0.25 * 0.5 * surface_tension(*c.fluid);
  c.substrate->surface_modulus = {0, 0.51 * needed};
  EXPECT_NO_THROW((Scene<2, 2>{c}));
  c.substrate->surface_modulus = {0, 0.49 * needed};
  expect_error(Exit::invalid_input, {"fluid.wall_stretch_exponent = 0.5", "substrate.surface_modulus", "wall_tension"},
               [&] { Scene<2, 2>{c}; });
  c.fluid->contact_angle = 60;
  c.substrate->surface_modulus = {};
  EXPECT_NO_THROW((Scene<2, 2>{c}));
}

}  // namespace
}  // namespace softwet::testing_tools
