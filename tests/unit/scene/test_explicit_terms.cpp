// The parts of the equations that explicit schemes evaluate add up to the residual.
#include "scene/explicit_terms.hpp"

#include "field/vector.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

template <int D>
void expect_parts_of_residual(const Case& c) {
  RandomSceneIn<D> s(c);
  Stage stage = s.stage();
  stage.moment_rate = 0;  // the moments count apart
  stage.acceleration = Array("acceleration", s.layout().velocity_size());
  const std::vector<double> whole = s.residual(stage);
  const ExplicitTerms<D, 2> terms(s.scene.regions(), s.scene.coefficients(), s.scene.equations());
  const Array sum("sum", s.layout().size());
  terms.add_mass_flux(stage, sum);
  terms.add_pressure(stage, sum);
  terms.add_convection(stage, Viscosity::among_all, sum);
  terms.collect(sum);
  multiply(sum, s.scene.mask());
  const std::vector<double> parts = to_host(sum);
  const int last = s.layout().has_fluid ? s.layout().potential_offset() : s.layout().size();
  double largest = 0;
  for (int i = 0; i < last; ++i) largest = std::max(largest, std::abs(whole[i]));
  EXPECT_GT(largest, 0.01);
  for (int i = 0; i < last; ++i) ASSERT_NEAR(parts[i], whole[i], 1e-13 * std::max(1.0, largest)) << i;
}

TEST(ExplicitTerms, AddUpInTheCoupledScene) { expect_parts_of_residual<2>(small_case(SceneKind::coupled)); }
TEST(ExplicitTerms, AddUpWithTheBlendedTraction) {
  Case c = small_case(SceneKind::coupled, WallLaw::energy);
  c.fluid->traction = Traction::blended;
  c.fluid->gravity = {0.02, -0.05};
  expect_parts_of_residual<2>(c);
}
TEST(ExplicitTerms, AddUpOnARigidWall) {
  expect_parts_of_residual<2>(small_case(SceneKind::rigid, WallLaw::energy, true));
}
TEST(ExplicitTerms, AddUpInASolid) { expect_parts_of_residual<2>(small_case(SceneKind::solid)); }
TEST(ExplicitTerms, AddUpOnAFoundation) {
  Case c = small_case(SceneKind::coupled);
  c.boundary.side[1][0] = Side::free;
  c.parts.foundation.springs = {0.6, 0.3};
  c.parts.foundation.dashpots = {0.4, 0.7};
  expect_parts_of_residual<2>(c);
  c.substrate->viscosity = 0.2;
  expect_parts_of_residual<2>(c);
}
TEST(ExplicitTerms, AddUpInAxisymmetricScenes) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid})
    expect_parts_of_residual<2>(axisymmetric(small_case(kind, WallLaw::energy)));
}
TEST(ExplicitTerms, AddUpInSpace) { expect_parts_of_residual<3>(small_case_in_3d(SceneKind::coupled)); }

}  // namespace
}  // namespace softwet::testing_tools
