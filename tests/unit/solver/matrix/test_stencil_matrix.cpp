// The assembled Jacobian against products.
#include "solver/matrix/stencil_matrix.hpp"

#include "field/vector.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// The matrix, computed in single precision, against products with frozen geometry.
void check_matrix(const Case& c) {
  RandomScene s(c);
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  const Array y("y", s.layout().size());
  for (int n = 0; n < 3; ++n) {
    const Array z = s.direction();
    matrix.multiply(z, y);
    EXPECT_LT(distance(to_host(y), s.product(z, Geometry::frozen)), 1e-6);
  }
  // Prescribed values and ghosts count for nothing, and stay zero.
  const std::vector<double> mask = to_host(s.scene.mask());
  std::vector<double> held(mask.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = mask[i] == 0 ? 1.0 + i : 0.0;
  matrix.multiply(to_device<Array>(held), y);
  EXPECT_EQ(to_host(y), std::vector<double>(mask.size(), 0.0));
}

TEST(StencilMatrix, Coupled) { check_matrix(small_case(SceneKind::coupled)); }
TEST(StencilMatrix, CoupledPeriodic) { check_matrix(small_case(SceneKind::coupled, WallLaw::gradient, true)); }
TEST(StencilMatrix, Rigid) { check_matrix(small_case(SceneKind::rigid)); }
TEST(StencilMatrix, RigidPeriodic) { check_matrix(small_case(SceneKind::rigid, WallLaw::energy, true)); }
TEST(StencilMatrix, SolidAlone) { check_matrix(small_case(SceneKind::solid)); }

// Few elements around a periodic axis: stencils that wrap onto themselves.
TEST(StencilMatrix, ShortPeriodicAxes) {
  for (int n = 3; n < 15; ++n) {
    Case c = small_case(SceneKind::rigid, WallLaw::gradient, true);
    c.domain.elements = {n, 4};
    check_matrix(c);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
