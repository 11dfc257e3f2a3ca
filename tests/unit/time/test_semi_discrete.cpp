// The equations as y' = f(t, y): against the residual they come from, with both kinds of mass.
#include "time/semi_discrete.hpp"

#include "model/initial.hpp"
#include "time/runge_kutta.hpp"
#include "unit/model/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using System = SemiDiscrete<2, 2>;

/// A random state of a scene, and f of it.
struct RandomRates {
  RandomScene scene;
  System system;
  State state;
  Array y, rates;

  RandomRates(const Case& c, MassKind kind) : scene(c), system(scene.model, kind), state(empty_state(scene.layout())) {
    Kokkos::deep_copy(state.unknown, scene.stage().unknown);
    Kokkos::deep_copy(state.displacement, scene.stage().displacement);
    system.set_moments(state);
    y = Array("y", system.size());
    rates = Array("rates", system.size());
    system.pack(state, y);
    EXPECT_TRUE(system.rates(3.0, y, rates).empty());
  }
  /// The residual of the equations with these rates.
  std::vector<double> residual() {
    Stage s = system.stage();
    s.acceleration = Array("acceleration", scene.layout().velocity_size());
    Kokkos::deep_copy(s.acceleration, part(rates, 0, scene.layout().velocity_size()));
    Array full("full", scene.layout().size());
    Kokkos::deep_copy(Kokkos::subview(full, Kokkos::make_pair(0, scene.layout().velocity_size())), s.acceleration);
    move_ghosts(scene.layout(), full, GhostAction::update);
    Kokkos::deep_copy(s.acceleration, part(full, 0, scene.layout().velocity_size()));
    return scene.residual(s);
  }
};

double largest_between(const std::vector<double>& r, int first, int last) {
  double m = 0;
  for (int i = first; i < last; ++i) m = std::max(m, std::abs(r[i]));
  return m;
}

void expect_solved(const Case& c) {
  RandomRates s(c, MassKind::consistent);
  const Layout<2>& l = s.scene.layout();
  const std::vector<double> r = s.residual();
  EXPECT_LT(largest_between(r, 0, l.velocity_size()), 1e-9) << "momentum";
  if (!l.has_fluid) return;
  EXPECT_LT(largest_between(r, l.potential_offset(), l.size()), 1e-10) << "chemical potential";
  const std::vector<double> now = to_host(s.system.stage().unknown), given = to_host(s.state.unknown);
  for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(now[i], given[i], 1e-10) << "density";
  for (int i = l.density_offset(), k = l.velocity_size() + l.solid_size(); i < l.potential_offset(); ++i, ++k)
    ASSERT_NEAR(r[i] + to_host(s.rates)[k], 0, 1e-14) << "moments change by the fluxes";
}

TEST(SemiDiscrete, RatesSolveTheEquationsOfACoupledScene) { expect_solved(scene(Scene::coupled)); }
TEST(SemiDiscrete, RatesSolveTheEquationsOfAPeriodicScene) {
  expect_solved(scene(Scene::rigid, WallLaw::gradient, true));
}
TEST(SemiDiscrete, RatesSolveTheEquationsOfASolid) { expect_solved(scene(Scene::solid)); }

TEST(SemiDiscrete, StiffRatesAreThoseOfTheImplicitPartForNoStep) {
  RandomRates s(scene(Scene::coupled), MassKind::consistent);
  const Array out("out", s.system.size()), stiff("stiff", s.system.size()), y = to_device<Array>(to_host(s.y));
  ASSERT_TRUE(s.system.hold(s.y).empty());
  ASSERT_TRUE(s.system.stiff_rates(s.y, out).empty());
  ASSERT_TRUE(s.system.implicit_part(1e-9, y, stiff).empty());
  const std::vector<double> a = to_host(out), b = to_host(stiff);
  const double size = largest_between(b, 0, s.scene.layout().velocity_size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-5 * size);
}

// Velocities without a viscous acceleration: the solve fails, and its iterations are none that count.
TEST(SemiDiscrete, StiffRatesThatCannotBeFoundAreRefused) {
  RandomRates s(scene(Scene::coupled), MassKind::consistent);
  const Array out("out", s.system.size());
  ASSERT_TRUE(s.system.hold(s.y).empty());
  ASSERT_TRUE(s.system.stiff_rates(s.y, out).empty());
  const long before = s.system.counts().viscous;
  EXPECT_GT(before, 0);
  const Array broken = to_device<Array>(std::vector<double>(s.system.size(), std::numeric_limits<double>::infinity()));
  EXPECT_EQ(s.system.stiff_rates(broken, out).cause, Refusal::viscous_rate);
  EXPECT_EQ(s.system.counts().viscous, before);
}

TEST(SemiDiscrete, GentleAndStiffPartAddUp) {
  RandomRates s(scene(Scene::coupled), MassKind::consistent);
  const Array gentle("gentle", s.system.size()), stiff("stiff", s.system.size()), y = to_device<Array>(to_host(s.y));
  ASSERT_TRUE(s.system.gentle_rates(3.0, s.y, gentle).empty());
  ASSERT_TRUE(s.system.implicit_part(1e-9, y, stiff).empty());
  const std::vector<double> a = to_host(s.rates), b = to_host(gentle), c = to_host(stiff);
  const double size = largest_between(c, 0, s.scene.layout().velocity_size());
  EXPECT_GT(size, 1);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i] + c[i], 1e-5 * size);
}

TEST(SemiDiscrete, TheSumOfTheMomentsIsTheMassWithBothMasses) {
  for (const MassKind kind : {MassKind::consistent, MassKind::lumped}) {
    RandomRates s(scene(Scene::coupled), kind);
    State end = empty_state(s.scene.layout());
    s.system.copy_stage(3.0, s.y, s.rates, end);
    Stage stage = s.system.stage();
    EXPECT_NEAR(s.scene.model.integrals(stage).mass, total(alone, end.moment), 1e-12);
    const int first = s.scene.layout().velocity_size() + s.scene.layout().solid_size();
    EXPECT_NEAR(total(alone, part(s.rates, first, s.system.size())), 0, 1e-13) << "fluxes sum to zero";
  }
}

/// A run begins with the density of its case: moments of one mass matrix, inverted with the other, would smooth it.
TEST(SemiDiscrete, TheMomentsOfAStateGiveItsDensityBackWithBothMasses) {
  for (const MassKind kind : {MassKind::consistent, MassKind::lumped})
    for (const bool periodic : {false, true}) {
      RandomRates s(scene(Scene::coupled, WallLaw::gradient, periodic), kind);
      const Layout<2>& l = s.scene.layout();
      State start = empty_state(l);
      s.system.copy_stage(0.0, s.y, s.rates, start);
      const std::vector<double> before = to_host(start.unknown);
      s.system.set_moments(start);
      EXPECT_NEAR(s.scene.model.integrals(stage_at(l, start)).mass, total(alone, start.moment), 1e-12);
      s.system.pack(start, s.y);
      ASSERT_TRUE(s.system.rates(0.0, s.y, s.rates).empty());
      const std::vector<double> after = to_host(s.system.stage().unknown);
      for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(after[i], before[i], 1e-9);
    }
}

}  // namespace
}  // namespace softwet::testing_tools
