// The algebra of one step: parameters, relations between levels, tangent scales, conservation, uniform states.
#include "time/implicit/generalized_alpha.hpp"

#include "unit/model/branch_checks.hpp"

namespace softwet::testing_tools {
namespace {

using Integrator = GeneralizedAlpha<2, 2>;

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

/// A scene with a state whose levels are all random.
struct RandomState {
  RandomScene scene;
  Integrator integrator;
  State state;

  explicit RandomState(const Case& c) : scene(c), integrator(scene.model, 0.5) {
    const Stage& s = scene.stage();
    Patch<2>& p = scene.terms.patch;
    state = {3.0,
             s.unknown,
             s.acceleration,
             s.displacement,
             p.draw(scene.layout().solid_size(), -0.3, 0.3),
             p.draw(scene.layout().scalar_size(), 0.0, 0.01),
             p.draw(scene.layout().scalar_size(), -0.01, 0.01)};
    if (scene.layout().branches == 0) return;
    state.memory = p.draw(scene.layout().memory_size(), -0.01, 0.01);
    state.memory_rate = p.draw(scene.layout().memory_size(), -0.3, 0.3);
  }
  /// Admissible values for the middle of a step.
  Array values() {
    RandomScene other(scene.data);
    std::vector<double> x = to_host(other.stage().unknown), noise = to_host(scene.direction());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += 0.05 * noise[i];
    return to_device<Array>(x);
  }
};

/// The product of a step is that of the Jacobian, but where contact lines have friction: there the rows of the potential at the wall are
/// stiffer, the more the larger their residual is. @param exact  the product of the Jacobian with z at x
void check_product(RandomState& s, const Array& x, const Array& z, const std::vector<double>& exact) {
  const Layout<2>& l = s.scene.layout();
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
  const Array x = s.values(), z = s.scene.direction();
  const int n = s.scene.layout().size();
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
  s.integrator.model().product(s.integrator.stage(), z, out, Geometry::exact);
  const double error = distance(to_host(out), difference);
  std::printf("  tangent of a step against differences: %.1e\n", error);
  EXPECT_LT(error, 1e-9);
  check_product(s, x, z, to_host(out));
}
TEST(GeneralizedAlpha, TangentOfACoupledStep) { check_tangent(scene(Scene::coupled)); }
TEST(GeneralizedAlpha, TangentOfAPeriodicStep) { check_tangent(scene(Scene::rigid, WallLaw::gradient, true)); }
/// A scene that keeps the rates of the density beside the wall.
Case scene_with_rates(Scene kind, bool periodic = false) {
  Case c = scene(kind, WallLaw::energy, periodic);
  c.fluid->line_friction = 0.3;
  c.fluid->contact_angle_range = {50, 70};
  c.fluid->contact_angle = c.fluid->middle_of_range();
  c.fluid->creep_speed = 0.5;
  return c;
}
TEST(GeneralizedAlpha, TangentOfAStepWithRatesOfTheDensity) {
  check_tangent(scene_with_rates(Scene::coupled));
  check_tangent(scene_with_rates(Scene::rigid, true));
}
TEST(GeneralizedAlpha, LinesHaveNoFrictionWhereTimeStandsStill) {
  Case c = scene_with_rates(Scene::coupled);
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
  const Array x = with.values(), z = with.scene.direction(), a("a", x.extent(0)), b("b", x.extent(0));
  with.integrator.residual(x, a);
  without.integrator.residual(x, b);
  EXPECT_EQ(to_host(a), to_host(b));
  with.integrator.product(z, a);
  without.integrator.product(z, b);
  EXPECT_EQ(to_host(a), to_host(b));
}
TEST(GeneralizedAlpha, TangentOfASolidStep) { check_tangent(scene(Scene::solid)); }
/// A viscoelastic solid: one branch is slower than a step, the other one faster.
Case scene_with_branches(Scene kind, Strain strain = Strain::small) {
  Case c = scene(kind);
  c.substrate->strain = strain;
  c.substrate->branches = {{0.9, 0.3}, {1.7, 0.004}};
  return c;
}
TEST(GeneralizedAlpha, TangentOfAStepWithBranches) {
  for (const Strain strain : {Strain::small, Strain::finite}) {
    check_tangent(scene_with_branches(Scene::solid, strain));
    check_tangent(scene_with_branches(Scene::coupled, strain));
    check_tangent(axisymmetric(scene_with_branches(Scene::coupled, strain)));
  }
}

// Branches act on the momentum of the solid, and not at all where time stands still.
void check_still(Strain strain) {
  Case c = scene_with_branches(Scene::coupled, strain);
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
  end.memory = Array("memory", with.scene.layout().memory_size());
  end.memory_rate = with.scene.terms.patch.draw(with.scene.layout().memory_size(), -1, 1);
  with.integrator.finish(x, end);
  const std::vector<double> memory = to_host(end.memory), x_followed = followed(with.scene.model, end.displacement);
  for (std::size_t i = 0; i < memory.size(); ++i) ASSERT_EQ(memory[i], x_followed[i % x_followed.size()]) << i;
  for (const double rate : to_host(end.memory_rate)) ASSERT_EQ(rate, 0);
}
TEST(GeneralizedAlpha, BranchesCarryNothingWhereTimeStandsStill) {
  check_still(Strain::small);
  check_still(Strain::finite);
}

/// y1 = y0 + dt ((1 - ga) y0' + ga y1')
void expect_newmark(const Array& y0, const Array& r0, const Array& y1, const Array& r1, double dt, int count) {
  const double ga = 2.0 / 3;
  const std::vector<double> a = to_host(y0), b = to_host(r0), c = to_host(y1), d = to_host(r1);
  for (int i = 0; i < count; ++i) ASSERT_NEAR(c[i], a[i] + dt * ((1 - ga) * b[i] + ga * d[i]), 1e-14) << i;
}

// Whatever x is, converged or not, the levels obey the scheme and no moment is lost.
void check_finish(const Case& c) {
  RandomState s(c);
  const Layout<2>& l = s.scene.layout();
  const double dt = 0.02, am = 5.0 / 6, af = 2.0 / 3, ga = 2.0 / 3;
  s.integrator.begin(s.state, dt);
  const Array x = s.values(), r("r", l.size());
  s.integrator.residual(x, r);
  RandomState e(c);
  State& end = e.state;  // arrays of their own
  s.integrator.finish(x, end);
  EXPECT_DOUBLE_EQ(end.time, 3.0 + dt);
  expect_newmark(s.state.unknown, s.state.velocity_rate, end.unknown, end.velocity_rate, dt, l.velocity_size());
  expect_newmark(s.state.displacement, s.state.displacement_rate, end.displacement, end.displacement_rate, dt,
                 l.solid_size());
  expect_newmark(s.state.moment, s.state.moment_rate, end.moment, end.moment_rate, dt, l.scalar_size());
  const std::vector<double> v = to_host(x), u0 = to_host(s.state.displacement_rate), y0 = to_host(s.state.unknown);
  const std::vector<double> u1 = to_host(end.displacement_rate), y1 = to_host(end.unknown);
  for (int d = 0; d < 2; ++d)
    for (int i = 0; i < l.solid_rows() * l.row_size; ++i) {
      const int k = l.displacement_offset(d) + i;
      ASSERT_NEAR((1 - am) * u0[k] + am * u1[k], v[l.velocity_offset(d) + i], 1e-14) << "u' at n+am is v at n+af";
    }
  for (int i = 0; i < l.velocity_size(); ++i) ASSERT_NEAR((1 - af) * y0[i] + af * y1[i], v[i], 1e-14);
  if (!l.has_fluid) return;
  double before = 0, after = 0, rate = 0;
  for (double p : to_host(s.state.moment)) before += p;
  for (double p : to_host(s.state.moment_rate)) rate += p;
  for (double p : to_host(end.moment)) after += p;
  EXPECT_NEAR(after, before + dt * (1 - ga / am) * rate, 1e-15 * 10) << "fluxes sum to zero";
  // The density is extrapolated, then shifted by one constant that gives it the mass of the moments.
  const int first = l.density_offset();
  const double shift = y1[first] - (v[first] - (1 - af) * y0[first]) / af;
  for (int i = first; i < l.potential_offset(); ++i) ASSERT_NEAR(y1[i] - shift, (v[i] - (1 - af) * y0[i]) / af, 1e-14);
  const std::vector<double> rate0 = to_host(s.state.velocity_rate), rate1 = to_host(end.velocity_rate);
  for (int i = first; i < l.rate_size(); ++i)
    ASSERT_NEAR(y1[i] - shift, y0[i] + dt * ((1 - ga) * rate0[i] + ga * rate1[i]), 1e-14) << "of the density";
  for (int i = l.potential_offset(); i < l.size(); ++i) ASSERT_NEAR((1 - af) * y0[i] + af * y1[i], v[i], 1e-14) << "mu";
  const double found = s.scene.model.integrals(stage_at(s.scene.layout(), end))["mass"];
  EXPECT_NEAR(found, after, l.has_solid ? 0.2 * std::abs(shift) : 1e-15) << "the volume is that of the fixed mesh";
  // p1 = M rho1 less the final residual, rho1 before the shift; M rho1 is what a fresh start from these fields takes.
  State fresh = end;
  std::vector<double> unshifted = y1;
  for (int i = first; i < l.potential_offset(); ++i) unshifted[i] -= shift;
  fresh.unknown = to_device<Array>(unshifted);
  fresh.moment = Array("moment", l.scalar_size());
  fresh.moment_rate = Array("rate", l.scalar_size());
  s.integrator.initialise(fresh);
  const std::vector<double> mass = to_host(fresh.moment), p = to_host(end.moment), residual = to_host(r);
  for (int i = 0; i < l.scalar_size(); ++i)
    ASSERT_NEAR(p[i], mass[i] - ga * dt / am * residual[l.density_offset() + i], 1e-15);
}
TEST(GeneralizedAlpha, FinishOfACoupledStep) { check_finish(scene(Scene::coupled)); }
TEST(GeneralizedAlpha, FinishOfARigidStep) { check_finish(scene(Scene::rigid)); }
TEST(GeneralizedAlpha, FinishOfAStepWithRatesOfTheDensity) {
  check_finish(scene_with_rates(Scene::coupled));
  check_finish(scene_with_rates(Scene::rigid));
}
TEST(GeneralizedAlpha, FinishOfASolidStep) { check_finish(scene(Scene::solid)); }

// tau a' = u - a, with a' at n + am and both displacements at n + af.
TEST(GeneralizedAlpha, FinishOfAStepWithBranches) {
  const Case c = scene_with_branches(Scene::coupled);
  check_finish(c);
  RandomState s(c), e(c);
  const double dt = 0.02, am = 5.0 / 6, af = 2.0 / 3;
  s.integrator.begin(s.state, dt);
  const Array x = s.values();
  s.integrator.finish(x, e.state);
  const int size = s.scene.layout().solid_size();
  expect_newmark(s.state.memory, s.state.memory_rate, e.state.memory, e.state.memory_rate, dt, 2 * size);
  const std::vector<double> u = to_host(s.integrator.stage().displacement), a0 = to_host(s.state.memory),
                            a1 = to_host(e.state.memory), r0 = to_host(s.state.memory_rate),
                            r1 = to_host(e.state.memory_rate);
  for (int k = 0; k < 2 * size; ++k)
    ASSERT_NEAR(c.substrate->branches[k / size].time * ((1 - am) * r0[k] + am * r1[k]),
                u[k % size] - (1 - af) * a0[k] - af * a1[k], 1e-14);
}

TEST(GeneralizedAlpha, InitialMomentsAreTheMass) {
  RandomState s(scene(Scene::coupled));
  s.integrator.initialise(s.state);
  double mass = 0, rate = 0, size = 0;
  for (double p : to_host(s.state.moment)) mass += p;
  for (double p : to_host(s.state.moment_rate)) {
    rate += p;
    size += std::abs(p);
  }
  EXPECT_NEAR(mass, s.scene.model.integrals(stage_at(s.scene.layout(), s.state))["mass"], 1e-15);
  EXPECT_GT(size, 1e-4);
  EXPECT_NEAR(rate, 0, 1e-14 * size);
}

/// Uniform fluid, driven through given wall velocities; calls check(state before, x) at every step.
template <class Velocity, class Check>
void drive(RandomState& s, int steps, double end, const Velocity& velocity, const Check& check) {
  const Layout<2>& l = s.scene.layout();
  std::vector<double> y(l.size(), 0.0);
  for (int i = 0; i < l.scalar_size(); ++i) {
    y[l.density_offset() + i] = 0.5;
    y[l.potential_offset() + i] = s.scene.model.fluid().gas.derivative(0.5);
  }
  Kokkos::deep_copy(s.state.unknown, to_device<Array>(y));
  Kokkos::deep_copy(s.state.velocity_rate, 0.0);
  Kokkos::deep_copy(s.state.displacement_rate, 0.0);
  s.state.time = 0;
  s.integrator.initialise(s.state);
  for (int n = 0; n < steps; ++n) {
    const double dt = end / steps;
    const std::vector<double> old = to_host(s.state.unknown);
    std::vector<double> x = old;
    for (int i = 0; i < l.velocity_size(); ++i) x[i] += 2.0 / 3 * (velocity(i, (n + 1) * dt) - x[i]);
    s.integrator.begin(s.state, dt);
    const Array middle = to_device<Array>(x);
    check(middle);
    s.integrator.finish(middle, s.state);
    std::vector<double> after = to_host(s.state.unknown);  // uniform again: only the moments tell what was lost
    std::copy(y.begin() + l.density_offset(), y.end(), after.begin() + l.density_offset());
    Kokkos::deep_copy(s.state.unknown, to_device<Array>(after));
  }
}

/// Largest relative deviation of the moments from those of the uniform state on the mesh of the end, away from the
/// wall's layer, where the prescribed velocity compresses the fluid.
double deviation(int steps) {
  RandomState s(scene(Scene::coupled));
  const Layout<2>& l = s.scene.layout();
  Kokkos::deep_copy(s.state.displacement, 0.0);
  const std::vector<double> shape = to_host(s.scene.stage().unknown);
  const auto velocity = [&](int i, double t) {
    const int row = i / l.row_size % l.rows;
    const double a = std::sin(M_PI * t);
    return row == l.wall_row ? 0.1 * shape[i] * a * a : 0.0;
  };
  RandomState uniform(scene(Scene::coupled));
  drive(s, steps, 0.8, velocity, [](const Array&) {});
  State fresh = s.state;
  fresh.moment = Array("moment", l.scalar_size());
  fresh.moment_rate = Array("rate", l.scalar_size());
  uniform.integrator.initialise(fresh);
  const std::vector<double> p = to_host(s.state.moment), expected = to_host(fresh.moment);
  double worst = 0;
  for (int i = 3 * l.row_size; i < l.scalar_size(); ++i) worst = std::max(worst, std::abs(p[i] / expected[i] - 1));
  return worst;
}

TEST(GeneralizedAlpha, UniformDensityOnAMovingMeshIsKeptToSecondOrder) {
  const double a = deviation(20), b = deviation(40), c = deviation(80);
  std::printf("  deviation from uniform, 20, 40, 80 steps: %.2e %.2e %.2e\n", a, b, c);
  EXPECT_GT(a, 1e-9);
  EXPECT_NEAR(std::log2(a / b), 2, 0.25);
  EXPECT_NEAR(std::log2(b / c), 2, 0.15);
}

// All of it in translation above a wall that is not flat: J depends linearly on time's displacement, and the scheme
// keeps the uniform density exactly, however the velocity varies.
TEST(GeneralizedAlpha, UniformDensityInTranslationIsKeptExactly) {
  RandomState s(scene(Scene::coupled, WallLaw::gradient, true));
  const Layout<2>& l = s.scene.layout();
  const auto velocity = [&](int i, double t) { return i < l.velocity_offset(1) ? 0.3 * t + std::sin(3 * t) : 0.0; };
  double worst = 0;
  const Array r("r", l.size());
  drive(s, 12, 0.6, velocity, [&](const Array& x) {
    s.integrator.residual(x, r);
    const std::vector<double> v = to_host(r);
    for (int i = l.density_offset(); i < l.potential_offset(); ++i)
      worst = std::max(worst, std::abs(v[i]) / s.integrator.stage().moment_rate);
  });
  EXPECT_LT(worst, 1e-16) << "of moments around 5e-3";
}

}  // namespace
}  // namespace softwet::testing_tools
