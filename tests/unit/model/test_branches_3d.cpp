// Branches of a solid in 3D.
#include "unit/model/branch_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Branches3D, EnergyLaw) {
  for (const Strain strain : {Strain::small, Strain::finite})
    expect_energy_law_of_branches<3>(scene_in_space(Scene::solid), strain);
}

TEST(Branches3D, FeelNoRotation) { expect_energy_of_branches_to_feel_no_rotation<3>(scene_in_space(Scene::solid)); }

}  // namespace
}  // namespace softwet::testing_tools
