// The algebra of one step: parameters, tangents, and what counts where time stands still.
#include "unit/time/implicit/random_steps.hpp"

namespace softwet::testing_tools {
namespace {

TEST(AlphaParameters, FormulasAndOrder) {
  for (const double r : {0.0, 0.5, 1.0}) {
    const AlphaParameters a(r);
    EXPECT_NEAR(a.am, (3 - r) / (2 + 2 * r), 1e-15);
    EXPECT_NEAR(a.af, 1 / (1 + r), 1e-15);
    EXPECT_NEAR(a.ga, 0.5 + a.am - a.af, 1e-15) << "second order";
    EXPECT_GE(a.am, a.af);
    EXPECT_GE(a.af, 0.5);
  }
  EXPECT_NEAR(AlphaParameters(0.5).am, 5.0 / 6, 1e-15);
  EXPECT_NEAR(AlphaParameters(0.5).ga, 2.0 / 3, 1e-15);
}

/// The product of a step equals the product of the Jacobian, except where contact lines have friction: there the rows
/// of the potential at the wall are stiffer, the more the larger their residual is.
/// @param exact  the product of the Jacobian with z at x
void check_product(RandomState& s, const Array& x, const Array& z, const std::vector<double>& exact) {
  const Layout<2>& l = s.random.layout();
  const Array r("r", l.size()), out("out", l.size());
  s.integrator.residual(x, r);
  s.integrator.product(z, out);
  const std::vector<double> found = to_host(out), direction = to_host(z);
  if (l.rate_rows == 0) {
    EXPECT_EQ(found, exact);
    return;
  }
  double power = 0;
  for (int i = 0; i < l.size(); ++i) {
    const int k = i - l.potential_offset();
    const bool at_wall = k >= 0 && k < l.row_size;
    if (at_wall) power += (found[i] - exact[i]) * direction[l.density_offset() + k];
    if (!at_wall) {
      ASSERT_EQ(found[i], exact[i]) << i;
    }
  }
  EXPECT_LT(power, -1e-6);
}

void check_tangent(const Case& c) {
  RandomState s(c);
  s.integrator.begin(s.state, 0.02);
  const Array x = s.values(), z = s.random.direction();
  const int n = s.random.layout().size();
  const auto residual = [&](double e) {
    const Array y = to_device<Array>(to_host(x)), r("r", n);
    add_scaled(y, 0, e, z);
    s.integrator.residual(y, r);
    return to_host(r);
  };
  const double e = 1e-4;
  const std::vector<double> a = residual(e), b = residual(-e), d = residual(2 * e), f = residual(-2 * e);
  std::vector<double> difference(n);
  for (int i = 0; i < n; ++i) difference[i] = (8 * (a[i] - b[i]) - (d[i] - f[i])) / (12 * e);
  residual(0);
  const Array out("out", n);
  s.integrator.scene().equations().product(s.integrator.stage(), z, out, Geometry::exact);
  const double error = distance(to_host(out), difference);
  std::printf("  tangent of a step against differences: %.1e\n", error);
  EXPECT_LT(error, 1e-9);
  check_product(s, x, z, to_host(out));
}
TEST(GeneralizedAlpha, TangentOfACoupledStep) { check_tangent(small_case(SceneKind::coupled)); }
TEST(GeneralizedAlpha, TangentOfAPeriodicStep) { check_tangent(small_case(SceneKind::rigid, WallLaw::gradient, true)); }
TEST(GeneralizedAlpha, TangentOfAStepWithRatesOfTheDensity) {
  check_tangent(scene_with_rates(SceneKind::coupled));
  check_tangent(scene_with_rates(SceneKind::rigid, true));
}
TEST(GeneralizedAlpha, LinesHaveNoFrictionWhereTimeStandsStill) {
  Case c = scene_with_rates(SceneKind::coupled);
  RandomState with(c);
  c.fluid->line_friction = 0;
  c.fluid->contact_angle_range = {};
  RandomState without(c);
  for (RandomState* s : {&with, &without}) {
    s->state.unknown = with.state.unknown;
    s->state.displacement = with.state.displacement;
    s->state.displacement_rate = with.state.displacement_rate;
    s->state.moment = with.state.moment;
    s->integrator.begin_still(s->state, 0.02);
  }
  const Array x = with.values(), z = with.random.direction(), a("a", x.extent(0)), b("b", x.extent(0));
  with.integrator.residual(x, a);
  without.integrator.residual(x, b);
  EXPECT_EQ(to_host(a), to_host(b));
  with.integrator.product(z, a);
  without.integrator.product(z, b);
  EXPECT_EQ(to_host(a), to_host(b));
}
TEST(GeneralizedAlpha, TangentOfASolidStep) { check_tangent(small_case(SceneKind::solid)); }
TEST(GeneralizedAlpha, TangentOfAStepWithBranches) {
  for (const Strain strain : {Strain::small, Strain::finite}) {
    check_tangent(scene_with_branches(SceneKind::solid, strain));
    check_tangent(scene_with_branches(SceneKind::coupled, strain));
    check_tangent(axisymmetric(scene_with_branches(SceneKind::coupled, strain)));
  }
}

// Branches act on the momentum of the solid, and not at all where time stands still.
void check_still(Strain strain) {
  Case c = scene_with_branches(SceneKind::coupled, strain);
  RandomState with(c);
  c.substrate->branches = {};
  RandomState without(c);
  State plain = with.state;
  plain.memory = plain.memory_rate = {};
  const Array x = with.values(), a("a", x.extent(0)), b("b", x.extent(0));
  for (const bool still : {false, true}) {
    still ? with.integrator.begin_still(with.state, 0.02) : with.integrator.begin(with.state, 0.02);
    still ? without.integrator.begin_still(plain, 0.02) : without.integrator.begin(plain, 0.02);
    with.integrator.residual(x, a);
    without.integrator.residual(x, b);
    if (still) {
      EXPECT_EQ(to_host(a), to_host(b));
    } else {
      EXPECT_GT(distance(to_host(a), to_host(b)), 1e-3);
    }
  }
  State end = RandomState(c).state;
  end.memory = Array("memory", with.random.layout().memory_size());
  end.memory_rate = with.random.terms.patch.draw(with.random.layout().memory_size(), -1, 1);
  with.integrator.finish(x, end);
  const std::vector<double> memory = to_host(end.memory),
                            x_followed = followed(with.random.scene.regions(), end.displacement);
  for (std::size_t i = 0; i < memory.size(); ++i) ASSERT_EQ(memory[i], x_followed[i % x_followed.size()]) << i;
  for (const double rate : to_host(end.memory_rate)) ASSERT_EQ(rate, 0);
}
TEST(GeneralizedAlpha, BranchesCarryNothingWhereTimeStandsStill) {
  check_still(Strain::small);
  check_still(Strain::finite);
}

}  // namespace
}  // namespace softwet::testing_tools
