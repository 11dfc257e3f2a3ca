// Traction of the fluid on the wall against forces worked out by hand.
#include "observe/interface_table.hpp"

#include <gtest/gtest.h>

#include "unit/observe/core/homogeneous.hpp"

namespace softwet::testing_tools {
namespace {

/// A fluid at rest presses with p on the deformed wall. Its reference element (1, 0) has become (1 + u_x,x, u_y,x), so
/// the force per reference length is p (u_y,x, -(1 + u_x,x)): the tangent turned by a right angle, into the solid.
void expect_pressure(const Case& c, const Matrix<double, 2>& gradient) {
  const Homogeneous run(c, gradient);
  const double p = run.scene.coefficients().fluid().gas.pressure(Homogeneous::density);
  ASSERT_GT(std::abs(p), 0.01);
  const auto traction = wall_traction(run.scene.regions(), run.scene.equations(), run.stage());
  const int n = run.scene.layout().row_size;
  for (int i = 1; i < n - 1; ++i) {  // the sides take part at the ends
    EXPECT_NEAR(traction[0][i], p * gradient(1, 0), 1e-13) << i;
    EXPECT_NEAR(traction[1][i], -p * (1 + gradient(0, 0)), 1e-13) << i;
  }
  EXPECT_EQ(traction[0][0], 0);
  EXPECT_EQ(traction[0][n - 1], 0);
}

TEST(WallTraction, IsThePressureOfAFluidAtRest) {
  expect_pressure(small_case(SceneKind::rigid), {});
  expect_pressure(small_case(SceneKind::coupled), {});
}

TEST(WallTraction, IsPerReferenceAreaOfADeformedWall) {
  expect_pressure(small_case(SceneKind::coupled), {{{0.1, 0}, {0.2, -0.15}}});
  Case blended = small_case(SceneKind::coupled);
  blended.fluid->traction = Traction::blended;
  expect_pressure(blended, {{{0.1, 0}, {0.2, -0.15}}});
}

// Only the fluid and the solid act on a free control point of the wall, so what the solid's terms leave of the whole
// residual is the fluid's part; the solid's terms come from the reference assembly.
TEST(WallTraction, IsWhatTheSolidHasToBear) {
  Case c = small_case(SceneKind::coupled);
  c.loads.clear();
  RandomScene s(c);
  const Layout<2>& l = s.layout();
  const std::vector<double> all = s.residual(s.stage()),
                            solid = s.terms.naive(
                                std::get<Elastodynamics<SaintVenantKirchhoff>>(s.scene.coefficients().solid().law), 0,
                                l.solid_elements, false);
  const auto traction = wall_traction(s.scene.regions(), s.scene.equations(), s.stage());
  const std::vector<double> weight = l.axis[0].integrals(0, l.axis[0].length(), 0, l.axis[0].elements());
  for (int d = 0; d < 2; ++d)
    for (int i = 1; i < l.row_size - 1; ++i) {
      const int row = l.velocity_offset(d) + l.wall_shift() + i;
      EXPECT_NEAR(traction[d][i] * weight[i], solid[row] - all[row], 1e-12) << d << " " << i;
    }
}

}  // namespace
}  // namespace softwet::testing_tools
