// The equations as y' = f(t, y): against the residual they come from, with all kinds of mass.
#include "time/explicit/semi_discrete.hpp"

#include "scene/initial.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using System = SemiDiscrete<2, 2>;
constexpr MassKind kinds[] = {MassKind::consistent, MassKind::lumped, MassKind::corrected};

/// A random state of a scene, and f of it.
struct RandomRates {
  RandomScene random;
  System system;
  State state;
  Array y, rates;

  RandomRates(const Case& c, MassKind kind)
      : random(c), system(random.scene, kind), state(empty_state(random.layout())) {
    Kokkos::deep_copy(state.unknown, random.stage().unknown);
    Kokkos::deep_copy(state.displacement, random.stage().displacement);
    system.set_moments(state);
    y = Array("y", system.size());
    rates = Array("rates", system.size());
    Kokkos::deep_copy(system.velocities_of(y), part(state.unknown, 0, system.velocities()));
    Kokkos::deep_copy(system.displacements_of(y), state.displacement);
    Kokkos::deep_copy(system.moments_of(y), state.moment);
    EXPECT_TRUE(system.rates(3.0, y, rates).empty());
  }
  /// The residual of the equations with these rates.
  std::vector<double> residual() {
    Stage s = system.stage();
    s.acceleration = Array("acceleration", system.velocities());
    Array full("full", random.layout().size());
    Kokkos::deep_copy(system.velocities_of(full), system.velocities_of(rates));
    move_ghosts(random.layout(), full, GhostAction::update);
    Kokkos::deep_copy(s.acceleration, part(full, 0, system.velocities()));
    return random.residual(s);
  }
};

double largest_between(const std::vector<double>& r, int first, int last) {
  double m = 0;
  for (int i = first; i < last; ++i) m = std::max(m, std::abs(r[i]));
  return m;
}

void expect_solved(const Case& c) {
  RandomRates s(c, MassKind::consistent);
  const Layout<2>& l = s.random.layout();
  const std::vector<double> r = s.residual();
  EXPECT_LT(largest_between(r, 0, l.velocity_size()), 1e-9) << "momentum";
  if (!l.has_fluid) return;
  EXPECT_LT(largest_between(r, l.potential_offset(), l.size()), 1e-10) << "chemical potential";
  const std::vector<double> now = to_host(s.system.stage().unknown), given = to_host(s.state.unknown);
  for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(now[i], given[i], 1e-10) << "density";
  for (int i = l.density_offset(), k = l.velocity_size() + l.solid_size(); i < l.potential_offset(); ++i, ++k)
    ASSERT_NEAR(r[i] + to_host(s.rates)[k], 0, 1e-14) << "moments change by the fluxes";
}

TEST(SemiDiscrete, RatesSolveTheEquationsOfACoupledScene) { expect_solved(small_case(SceneKind::coupled)); }
TEST(SemiDiscrete, RatesSolveTheEquationsOfAPeriodicScene) {
  expect_solved(small_case(SceneKind::rigid, WallLaw::gradient, true));
}
TEST(SemiDiscrete, RatesSolveTheEquationsOfASolid) { expect_solved(small_case(SceneKind::solid)); }
TEST(SemiDiscrete, RatesSolveTheEquationsOfAxisymmetricScenes) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid})
    expect_solved(axisymmetric(small_case(kind)));
}

TEST(SemiDiscrete, RatesAreTheSumOfTheirParts) {
  for (const MassKind kind : kinds) {
    RandomRates s(small_case(SceneKind::coupled), kind);
    System& system = s.system;
    const Array pressure("p", system.velocities()), convection("c", system.velocities());
    const Array flux("f", system.moments()), stabilisation("e", system.moments());
    auto forced = system.take_rates(system.pressure(system.evaluated(), pressure), stabilisation);
    auto moved = system.find_flux(system.convection(std::move(forced), Viscosity::among_all, convection));
    const Array none("none", system.moments());
    ASSERT_TRUE(system.move_moments(std::move(moved), 1, none, stabilisation, flux).refusal().empty());
    add_scaled(pressure, 0, 1, convection);
    const std::vector<double> a = to_host(pressure), b = to_host(flux), rates = to_host(s.rates);
    const int shift = system.velocities() + system.displacements();
    const double size = largest_between(rates, 0, system.velocities());
    for (int i = 0; i < system.velocities(); ++i) ASSERT_NEAR(a[i], rates[i], 1e-7 * size);
    for (int i = 0; i < system.moments(); ++i) ASSERT_NEAR(b[i], rates[shift + i], 1e-13);
  }
}

TEST(SemiDiscrete, ConvectionWithoutViscosityAndViscosityAddUp) {
  RandomRates s(small_case(SceneKind::coupled), MassKind::corrected);
  System& system = s.system;
  const Array both("b", system.velocities()), convection("c", system.velocities()), viscous("v", system.velocities());
  auto at = system.convection(system.evaluated(), Viscosity::among_all, both);
  const auto end = system.convection(std::move(at), Viscosity::apart, convection);
  ASSERT_TRUE(system.viscosity(end, system.velocities_of(s.y), viscous).empty());
  const std::vector<double> sum = to_host(both), a = to_host(convection), b = to_host(viscous);
  const double size = largest_between(b, 0, system.velocities());
  EXPECT_GT(size, 1);
  for (int i = 0; i < system.velocities(); ++i) ASSERT_NEAR(sum[i], a[i] + b[i], 1e-11 * size);
}

// Velocities without a viscous acceleration: the solve fails, and its iterations are none that count.
TEST(SemiDiscrete, ViscousRatesThatCannotBeFoundAreRefused) {
  RandomRates s(small_case(SceneKind::coupled), MassKind::consistent);
  const Array out("out", s.system.velocities());
  ASSERT_TRUE(s.system.viscosity(s.system.evaluated(), s.system.velocities_of(s.y), out).empty());
  const long before = s.system.counts().viscous;
  EXPECT_GT(before, 0);
  const Array broken =
      to_device<Array>(std::vector<double>(s.system.velocities(), std::numeric_limits<double>::infinity()));
  EXPECT_EQ(s.system.viscosity(s.system.evaluated(), broken, out).cause, Refusal::viscous_rate);
  EXPECT_EQ(s.system.counts().viscous, before);
}

TEST(SemiDiscrete, TheSumOfTheMomentsIsTheMassWithAllMasses) {
  for (const MassKind kind : kinds)
    for (const bool periodic : {false, true}) {
      RandomRates s(small_case(SceneKind::coupled, WallLaw::gradient, periodic), kind);
      const Array p = s.system.moments_of(s.y);
      EXPECT_NEAR(s.random.scene.balance().measure(s.system.stage()).integrals["mass"], total(alone, p), 1e-12);
      EXPECT_NEAR(total(alone, s.system.moments_of(s.rates)), 0, 1e-13) << "fluxes sum to zero";
    }
}

/// A run begins with the density of its case: moments of one mass matrix, inverted with the other, would smooth it.
TEST(SemiDiscrete, TheMomentsOfAStateGiveItsDensityBack) {
  for (const auto& [kind, error] : {std::pair{MassKind::consistent, 1e-9}, {MassKind::lumped, 1e-12}}) {
    RandomRates s(small_case(SceneKind::coupled), kind);
    const Layout<2>& l = s.random.layout();
    const std::vector<double> before = to_host(s.state.unknown), after = to_host(s.system.stage().unknown);
    for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(after[i], before[i], error);
  }
}

TEST(SemiDiscrete, TheMomentsOfADropletGiveItsDensityBackWithCorrectedMasses) {
  for (const bool periodic : {false, true}) {
    Case c = small_case(SceneKind::coupled, WallLaw::energy, periodic);
    c.domain.elements = {27, 24};
    c.droplets = {{{0.45, 0.8 / 3}, 0.2}};
    c.fluid->capillarity = 0.05;
    const Scene<2, 2> scene(c);
    System system(scene, MassKind::corrected);
    State state = initial_state<2, 2>(c, scene);
    system.set_moments(state);
    ASSERT_TRUE(system.find_density(system.evaluated(), state.moment).refusal().empty());
    const std::vector<double> before = to_host(state.unknown), after = to_host(system.stage().unknown);
    const Layout<2>& l = scene.layout();
    for (int i = l.density_offset(); i < l.potential_offset(); ++i) ASSERT_NEAR(after[i], before[i], 2e-6);
    EXPECT_NEAR(scene.balance().measure(stage_at(l, state)).integrals["mass"], total(alone, state.moment), 1e-13);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
