// Branches of a solid in 3D.
#include "unit/scene/branch_checks.hpp"

namespace softwet::testing_tools {
namespace {

TEST(Branches3D, EnergyLaw) {
  for (const Strain strain : {Strain::small, Strain::finite})
    expect_energy_law_of_branches<3>(small_case_in_3d(SceneKind::solid), strain);
}

TEST(Branches3D, FeelNoRotation) {
  expect_energy_of_branches_to_feel_no_rotation<3>(small_case_in_3d(SceneKind::solid));
}

}  // namespace
}  // namespace softwet::testing_tools
