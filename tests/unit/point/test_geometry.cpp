// The map at a point: gradients, fluxes and measures against explicit deformations.
#include "kernels/point/geometry.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

// x = (2 X + Y/2, 3 Y): F = [[2, 1/2], [0, 3]].
TEST(Geometry, AffineMapByHand) {
  const Matrix<double, 2> gradient{{{1, 0.5}, {0, 2}}};
  const MovingPoint<double, 2> p(gradient, {{0.25, -4}}, {{7, 8}});
  EXPECT_DOUBLE_EQ(p.volume, 6);
  EXPECT_DOUBLE_EQ(p.measured(0.5), 3);
  EXPECT_EQ(p.position[1], 8);
  EXPECT_EQ(p.mesh_velocity()[1], -4);
  // g = 5 x + 7 y in current coordinates is 10 X + (5/2 + 21) Y.
  const auto g = p.physical({{10, 23.5}});
  EXPECT_DOUBLE_EQ(g[0], 5);
  EXPECT_DOUBLE_EQ(g[1], 7);
  // The power of a flux is equal in both configurations: J flux . grad_x q = reference_flux . Grad q.
  const Vector<double, 2> flux{{0.3, -1.1}};
  const auto f = p.reference_flux(flux);
  EXPECT_NEAR(f[0] * 10 + f[1] * 23.5, 6 * (0.3 * 5 - 1.1 * 7), 1e-13);
}

TEST(Geometry, FaceMeasureIsTheAreaOfTheTangents) {
  const Matrix<double, 2> g2{{{0.2, 0.7}, {-0.4, 0.1}}};
  EXPECT_NEAR((MovingFace<double, 2>(MovingPoint<double, 2>(g2, {}, {})).measured(1.0)), std::hypot(1.2, 0.4), 1e-15);
  const Matrix<double, 3> g3{{{0.2, 0.1, 0.9}, {-0.4, 0.3, -0.2}, {0.5, -0.1, 0.4}}};
  const double a[3] = {1.2, -0.4, 0.5}, b[3] = {0.1, 1.3, -0.1};
  const double area = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  EXPECT_NEAR((MovingFace<double, 3>(MovingPoint<double, 3>(g3, {}, {})).measured(1.0)), area, 1e-15);
}

TEST(Geometry, IdentityMapEqualsAMapThatDoesNotMove) {
  const Matrix<double, 3> zero{};
  const MovingPoint<double, 3> moving(zero, {}, {});
  const FixedPoint<double, 3> fixed{};
  const Vector<double, 3> g{{1, 2, 3}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(moving.physical(g)[i], fixed.physical(g)[i]);
    EXPECT_EQ(moving.reference_flux(g)[i], fixed.reference_flux(g)[i]);
    EXPECT_EQ(fixed.mesh_velocity()[i], 0);
  }
  EXPECT_EQ(moving.measured(7.0), fixed.measured(7.0));
}

/// The closed form of the map's tangent against dual numbers.
template <int D>
void check_varied(const Matrix<double, D>& gradient, const Matrix<double, D>& tangent) {
  using N = Dual<double>;
  Matrix<N, D> f;
  Vector<N, D> velocity, place, reference, flux;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) f(i, j) = {gradient(i, j), tangent(i, j)};
    velocity[i] = {0.3 + i, -0.2 * i};
    place[i] = {1.0 * i, 0.7};
    reference[i] = {0.4 - i, 0.9 + 0.3 * i};
    flux[i] = {1.1 * i - 0.5, 0.2 + i};
  }
  const MovingPoint<N, D> dual(f, velocity, place);
  const VariedPoint<double, D> varied(gradient, tangent, velocity, place);
  const Vector<N, D> g = dual.physical(reference), h = varied.physical(reference);
  const Vector<N, D> expected = dual.reference_flux(flux);
  const Vector<double, D> found = varied.reference_flux(flux);
  for (int i = 0; i < D; ++i) {
    EXPECT_NEAR(h[i].value, g[i].value, 1e-14);
    EXPECT_NEAR(h[i].tangent, g[i].tangent, 1e-13);
    EXPECT_NEAR(found[i], expected[i].tangent, 1e-13);
    EXPECT_EQ(varied.mesh_velocity()[i].tangent, velocity[i].tangent);
  }
  const N x(0.8, -1.7);
  EXPECT_NEAR(varied.measured(x), dual.measured(x).tangent, 1e-13);
  EXPECT_NEAR(varied.volume_ratio().value, dual.volume_ratio().value, 1e-14);
  EXPECT_NEAR(varied.volume_ratio().tangent, dual.volume_ratio().tangent, 1e-13);
}

TEST(Geometry, TangentOfTheMapInClosedForm) {
  check_varied<2>({{{0.2, 0.7}, {-0.4, 0.1}}}, {{{1.2, -0.3}, {0.5, 0.8}}});
  check_varied<3>({{{0.2, 0.1, 0.9}, {-0.4, 0.3, -0.2}, {0.5, -0.1, 0.4}}},
                  {{{-0.6, 0.2, 0.3}, {0.1, 0.9, -0.7}, {0.4, 0.8, 0.5}}});
}

}  // namespace
}  // namespace softwet
