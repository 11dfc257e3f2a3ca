// Scenes whose wall has an exponent of its stretch: residual against the energy, and the exact product.
#pragma once

#include "unit/scene/formulas.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

inline Case with_exponent(Case c, double beta) {
  c.fluid->wall_stretch_exponent = beta;
  c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.4;
  c.substrate->surface_modulus = {0.3, 0.2};
  return c;
}

template <int D>
void check_product(RandomSceneIn<D>& s) {
  const Array z = s.direction();
  EXPECT_LT(distance(s.product(z, Geometry::exact), s.difference(z, 1e-4)), 1e-9);
  if (D == 3) return;  // there matrices have a quadrature of their own (matrix_points)
  const Array free("free", s.layout().size()), y("y", s.layout().size());
  Kokkos::deep_copy(free, 1.0);
  StencilMatrix<D> matrix(s.layout(), free);
  matrix.fill(s.jacobian());
  matrix.multiply(z, y);
  multiply(y, s.scene.mask());
  EXPECT_LT(distance(to_host(y), s.product(z, Geometry::frozen)), 1e-5);
}

/// The rate of the wall energy by the motion of the wall is the column wall_stretch, and the work of the tension of the
/// wall; by the density it is the equation of the potential that says so.
template <int D>
void check_stretched_wall(const Case& c) {
  RandomSceneIn<D> none(c);
  Case other = c;
  other.fluid->wall_tension = WallTensionModel::acts;
  RandomSceneIn<D> acts(other);
  const Layout<D>& l = none.layout();
  const std::vector<double> x = to_host(none.stage().unknown), before = none.residual(none.stage()),
                            after = acts.residual(acts.stage());
  const double stretch = none.scene.balance().measure(none.stage()).integrals["wall_stretch"],
               turn = none.scene.regions().turn();
  EXPECT_EQ(acts.scene.balance().measure(acts.stage()).integrals["wall_stretch"], 0);
  std::vector<double> motion(l.solid_size());
  for (int d = 0; d < D; ++d)
    std::copy_n(&x[l.velocity_offset(d)], l.solid_rows() * l.row_size, &motion[l.displacement_offset(d)]);
  const auto energy_where_moved = [&](double time) {
    Stage moved = none.stage();
    moved.displacement = plus(moved.displacement, time, motion);
    return none.scene.balance().measure(moved).integrals["energy_wall"];
  };
  EXPECT_GT(std::abs(stretch), 1e-5);
  EXPECT_NEAR(slope(energy_where_moved, 2e-4), stretch, 1e-9 * std::abs(stretch));
  EXPECT_NEAR(turn * (contract(after, x, 0, l.velocity_size()) - contract(before, x, 0, l.velocity_size())), stretch,
              1e-11);

  other = c;
  other.fluid->contact_angle = 90;
  RandomSceneIn<D> upright(other);
  const std::vector<double> without = upright.residual(none.stage()), rate = to_host(none.direction());
  std::vector<double> of_density(l.size(), 0.0);
  double power = 0;
  for (int i = 0; i < l.scalar_size(); ++i) {
    of_density[l.density_offset() + i] = rate[l.density_offset() + i];
    power -= (before[l.potential_offset() + i] - without[l.potential_offset() + i]) * rate[l.density_offset() + i];
  }
  const auto energy_where_denser = [&](double time) {
    Stage moved = none.stage();
    moved.unknown = plus(moved.unknown, time, of_density);
    return none.scene.balance().measure(moved).integrals["energy_wall"];
  };
  EXPECT_GT(std::abs(power), 1e-5);
  EXPECT_NEAR(slope(energy_where_denser, 1e-4), turn * power, 1e-8 * std::abs(turn * power));
  check_product(none);
  check_product(acts);
}

}  // namespace softwet::testing_tools
