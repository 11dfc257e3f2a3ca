// Products axis by axis against the masses assembled element by element.
#include "solver/krylov/mass_product.hpp"

#include "scene/mass_products.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// out = M in value by value, as the items of a device have it.
template <int D>
void multiply_values(const MassProduct<D, 2>& product, const Array& in, const Array& out, Unknowns of) {
  const BandProduct<D, 2> values = product.of(in, of);
  Kokkos::parallel_for(
      "values", Items(0, in.extent(0)),
      KOKKOS_LAMBDA(int item) { values.for_values(OneValue{item}, [&](int i, int, double sum) { out(i) = sum; }); });
}

template <int D>
void expect_product(const Case& c) {
  RandomSceneIn<D> s(c);
  const Layout<D>& l = s.layout();
  const MassProduct<D, 2> product(l, s.scene.regions().points());
  const Masses<D, 2> masses(s.scene.regions(), s.scene.coefficients());
  Stage flat = make_stage<double>(l);
  const Array z = s.direction(), found("found", l.size()), expected("expected", l.size());
  masses.scalar(flat, z, expected);
  move_ghosts(l, z, GhostAction::update);
  const auto cut = [](const Array& a, int first, int last) {
    return Kokkos::subview(a, Kokkos::make_pair(first, last));
  };
  const int density = l.density_offset(), potential = l.potential_offset();
  product.apply(cut(z, density, potential), cut(found, density, potential), D, D + 1);
  product.apply(cut(z, 0, density), cut(found, 0, density), 0, D);
  const Array by_value("by value", l.size());
  multiply_values(product, cut(z, density, potential), cut(by_value, density, potential), Unknowns::scalars);
  multiply_values(product, cut(z, 0, density), cut(by_value, 0, density), Unknowns::velocities);
  for (const Array& x : {found, by_value}) multiply(x, s.scene.mask());
  const std::vector<double> a = to_host(expected), b = to_host(found), one = to_host(by_value);
  for (int i = 0; i < l.potential_offset(); ++i) ASSERT_NEAR(one[i], b[i], 1e-15) << i;
  for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(a[i], b[i], 1e-14);
  if (l.has_solid) return;
  // Velocities, weighted with a density of 1.
  Kokkos::deep_copy(flat.unknown, 1.0);
  Kokkos::deep_copy(expected, 0.0);
  masses.velocity(flat, 1, 0, z, expected);
  const std::vector<double> v = to_host(expected);
  for (int i = 0; i < l.velocity_size(); ++i) ASSERT_NEAR(v[i], b[i], 1e-14);
}

TEST(MassProduct, IsThatOfElementsInThePlane) { expect_product<2>(small_case(SceneKind::rigid)); }
TEST(MassProduct, IsThatOfElementsAboveASolid) { expect_product<2>(small_case(SceneKind::coupled)); }
TEST(MassProduct, IsThatOfElementsAroundAnAxis) {
  expect_product<2>(small_case(SceneKind::rigid, WallLaw::gradient, true));
}
TEST(MassProduct, IsThatOfElementsWithTheWeightOfTheRadius) {
  expect_product<2>(axisymmetric(small_case(SceneKind::rigid)));
  expect_product<2>(axisymmetric(small_case(SceneKind::coupled)));
}
TEST(MassProduct, IsThatOfElementsInSpace) {
  Case c = small_case_in_3d(SceneKind::rigid);
  expect_product<3>(c);
  c.domain.elements = {5, 8, 24};  // several blocks of lines
  expect_product<3>(c);
  c.boundary.side[0] = c.boundary.side[1] = {Side::periodic, Side::periodic};
  expect_product<3>(c);
  c = small_case_in_3d(SceneKind::coupled);
  c.domain.elements = {5, 8, 24};
  expect_product<3>(c);
}

}  // namespace
}  // namespace softwet::testing_tools
