// Branches of a solid in 2D and in (r, z).
#include "unit/scene/branch_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Branches2D, EnergyLaw) {
  for (const Strain strain : {Strain::small, Strain::finite}) {
    expect_energy_law_of_branches<2>(small_case(SceneKind::solid), strain);
    expect_energy_law_of_branches<2>(axisymmetric(small_case(SceneKind::solid)), strain);
  }
}

TEST(Branches2D, FeelNoRotation) { expect_energy_of_branches_to_feel_no_rotation<2>(small_case(SceneKind::solid)); }

TEST(Branches2D, RememberAsMuchAsTheyNeed) {
  Case c = small_case(SceneKind::solid);
  c.substrate->branches = {{0.9, 0.3}, {1.7, 0.04}};
  const Regions<2> finite(c), around(axisymmetric(c));
  c.substrate->strain = Strain::small;
  const Regions<2> small(c);
  EXPECT_EQ(small.layout().branch_size(), small.layout().solid_size());
  EXPECT_EQ(finite.layout().branch_size(), 6 * 3 * 9 * finite.layout().extent(0));
  EXPECT_EQ(around.layout().branch_size(), 6 * 4 * 9 * around.layout().extent(0));
  EXPECT_EQ(finite.layout().memory_size(), 2 * finite.layout().branch_size());
}

}  // namespace
}  // namespace softwet::testing_tools
