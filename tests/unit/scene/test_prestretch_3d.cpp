// A stretched layer in 3D: it is at rest where its displacement is 0, and testing with v gives the rate of its energy.
#include "unit/scene/rates.hpp"
#include "unit/scene/stretched.hpp"

namespace softwet::testing_tools {
namespace {

TEST(PrestretchedLayer3D, IsAtRestWhereItsDisplacementIsZero) {
  for (const MaterialModel material : {MaterialModel::neo_hookean, MaterialModel::saint_venant_kirchhoff})
    EXPECT_LT(largest_at_rest<3>(stretched(small_case_in_3d(SceneKind::solid), {1.15, 0.95}, material)), 1e-15)
        << word_of(material);
}

TEST(PrestretchedLayer3D, EnergyLaw) {
  Case c = stretched(small_case_in_3d(SceneKind::solid), {1.3, 0.9});
  c.substrate->fibre = {0.5, 0, 90};
  RandomSceneIn<3> s(c);
  const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
  const double expected = s.rate_of_energy(2e-4) - s.scene.balance().measure(s.stage()).load_power;
  EXPECT_NEAR(contract(r, x, 0, s.layout().size()), expected, 1e-9 * std::abs(expected));
}

}  // namespace
}  // namespace softwet::testing_tools
