// The driver in degree 3, with terms that compile quickly: in the volume, on the wall, and in the layer at the wall.
#include "term_cases.hpp"

namespace softwet::testing_tools {
namespace {

using Cubic = TermCases<2, 3>;
Cubic cubic() { return Cubic(std::array<int, 2>{11, 7}); }

TEST(TermsOfDegree3, VolumeOnMovingMesh) {
  const Cubic c = cubic();
  const VariationalDerivative term{c.terms.gas, 0.4};
  c.check<WallMotion>("variational_derivative", term, c.patch.fluid(), 2, 7);
}
TEST(TermsOfDegree3, WallOnMovingMesh) {
  const Cubic c = cubic();
  c.check<WallMotion>("gradient_wall", c.terms.gradient_wall, c.patch.face(), 2, 3);
}
TEST(TermsOfDegree3, LayerBesideTheWall) {
  const Cubic c = cubic();
  c.check<Still>("capillary_traction", c.terms.traction, c.patch.layer(), 2, 3, c.patch.layout.wall_row);
}

}  // namespace
}  // namespace softwet::testing_tools
