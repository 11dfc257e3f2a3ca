// Scenes whose contact lines have friction and hysteresis: what that dissipates, and the exact product.
#pragma once

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

inline Case resisting(Case c) {
  c.fluid->line_friction = 0.3;
  c.fluid->contact_angle_range = {40, 80};
  c.fluid->contact_angle = c.fluid->middle_of_range();
  c.fluid->creep_speed = 0.2;
  return c;
}

/// What the term adds to the equation of the potential, times the rate of the density: minus the dissipation. And the
/// product of the scene.
template <int D>
void check_scene(Case c) {
  c.fluid->contact_angle = resisting(c).fluid->contact_angle;
  RandomSceneIn<D> without(c), with(resisting(c));
  const Layout<D>& l = with.layout();
  ASSERT_EQ(l.rate_size(), l.velocity_size() + 3 * l.row_size);
  ASSERT_EQ(without.layout().rate_size(), l.velocity_size());
  for (RandomSceneIn<D>* s : {&without, &with}) s->stage().unknown = with.stage().unknown;
  without.stage().displacement = with.stage().displacement;
  without.stage().displacement_end = with.stage().displacement_end;
  without.stage().density_end = with.stage().density_end;
  const std::vector<double> rate = to_host(with.stage().acceleration);
  without.stage().acceleration = to_device<Array>(std::vector<double>(rate.begin(), rate.begin() + l.velocity_size()));
  const std::vector<double> before = without.residual(without.stage()), after = with.residual(with.stage());
  double power = 0;
  for (int i = 0; i < l.potential_offset(); ++i) ASSERT_EQ(before[i], after[i]) << "of the other equations";
  for (int i = 0; i < l.row_size; ++i)
    power += (after[l.potential_offset() + i] - before[l.potential_offset() + i]) * rate[l.density_offset() + i];
  const Integrals now = with.scene.balance().measure(with.stage()).integrals,
                  then = without.scene.balance().measure(without.stage()).integrals;
  EXPECT_GT(now["dissipation_wall"], 1e-4);
  EXPECT_EQ(then["dissipation_wall"], 0);
  EXPECT_NEAR(with.scene.regions().turn() * power, -now["dissipation_wall"], 1e-12);
  EXPECT_NEAR(now.dissipation() - then.dissipation(), now["dissipation_wall"], 1e-12);
  const Array z = with.direction();
  const double error = distance(with.product(z, Geometry::exact), with.difference(z, 1e-4));
  std::printf("  product against differences: %.1e\n", error);
  EXPECT_LT(error, 1e-9);
}

}  // namespace softwet::testing_tools
