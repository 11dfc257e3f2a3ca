// The parts of the equations that explicit schemes evaluate add up to the residual.
#include "model/explicit_terms.hpp"

#include "field/vector.hpp"
#include "unit/model/scenes.hpp"

namespace softwet::testing_tools {
namespace {

template <int D>
void expect_parts_of_residual(const Case& c) {
  RandomSceneIn<D> s(c);
  Stage stage = s.stage();
  stage.moment_rate = 0;  // the moments count apart
  stage.acceleration = Array("acceleration", s.layout().velocity_size());
  const std::vector<double> whole = s.residual(stage);
  const ExplicitTerms<D, 2> terms(s.model);
  const Array sum("sum", s.layout().size());
  terms.add_mass_flux(stage, sum);
  terms.add_pressure(stage, sum);
  terms.add_convection(stage, Viscosity::among_all, sum);
  terms.collect(sum);
  multiply(sum, s.model.mask());
  const std::vector<double> parts = to_host(sum);
  const int last = s.layout().has_fluid ? s.layout().potential_offset() : s.layout().size();
  double largest = 0;
  for (int i = 0; i < last; ++i) largest = std::max(largest, std::abs(whole[i]));
  EXPECT_GT(largest, 0.01);
  for (int i = 0; i < last; ++i) ASSERT_NEAR(parts[i], whole[i], 1e-13 * std::max(1.0, largest)) << i;
}

TEST(ExplicitTerms, AddUpInTheCoupledScene) { expect_parts_of_residual<2>(scene(Scene::coupled)); }
TEST(ExplicitTerms, AddUpWithTheBlendedTraction) {
  Case c = scene(Scene::coupled, WallLaw::energy);
  c.fluid->traction = Traction::blended;
  c.fluid->gravity = {0.02, -0.05};
  expect_parts_of_residual<2>(c);
}
TEST(ExplicitTerms, AddUpOnARigidWall) { expect_parts_of_residual<2>(scene(Scene::rigid, WallLaw::energy, true)); }
TEST(ExplicitTerms, AddUpInASolid) { expect_parts_of_residual<2>(scene(Scene::solid)); }
TEST(ExplicitTerms, AddUpOnAFoundation) {
  Case c = scene(Scene::coupled);
  c.boundary.side[1][0] = Side::free;
  c.boundary.foundation = {0.6, 0.3};
  c.boundary.foundation_damping = {0.4, 0.7};
  expect_parts_of_residual<2>(c);
  c.substrate->viscosity = 0.2;
  expect_parts_of_residual<2>(c);
}
TEST(ExplicitTerms, AddUpInAxisymmetricScenes) {
  for (const Scene kind : {Scene::coupled, Scene::rigid, Scene::solid})
    expect_parts_of_residual<2>(axisymmetric(scene(kind, WallLaw::energy)));
}
TEST(ExplicitTerms, AddUpInSpace) { expect_parts_of_residual<3>(scene_in_space(Scene::coupled)); }

}  // namespace
}  // namespace softwet::testing_tools
