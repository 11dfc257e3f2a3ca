// How a step ends: relations between its levels, and conserved quantities.
#include "unit/time/implicit/random_steps.hpp"

namespace softwet::testing_tools {
namespace {

/// y1 = y0 + dt ((1 - ga) y0' + ga y1')
void expect_newmark(const Array& y0, const Array& r0, const Array& y1, const Array& r1, double dt, int count) {
  const double ga = 2.0 / 3;
  const std::vector<double> a = to_host(y0), b = to_host(r0), c = to_host(y1), d = to_host(r1);
  for (int i = 0; i < count; ++i) ASSERT_NEAR(c[i], a[i] + dt * ((1 - ga) * b[i] + ga * d[i]), 1e-14) << i;
}

// Whatever x is, converged or not, the levels obey the scheme and no moment is lost.
void check_finish(const Case& c) {
  RandomState s(c);
  const Layout<2>& l = s.random.layout();
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
  const double found = s.random.scene.balance().measure(stage_at(s.random.layout(), end)).integrals["mass"];
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
TEST(GeneralizedAlpha, FinishOfACoupledStep) { check_finish(small_case(SceneKind::coupled)); }
TEST(GeneralizedAlpha, FinishOfARigidStep) { check_finish(small_case(SceneKind::rigid)); }
TEST(GeneralizedAlpha, FinishOfAStepWithRatesOfTheDensity) {
  check_finish(scene_with_rates(SceneKind::coupled));
  check_finish(scene_with_rates(SceneKind::rigid));
}
TEST(GeneralizedAlpha, FinishOfASolidStep) { check_finish(small_case(SceneKind::solid)); }

// tau a' = u - a, with a' at n + am and both displacements at n + af.
TEST(GeneralizedAlpha, FinishOfAStepWithBranches) {
  const Case c = scene_with_branches(SceneKind::coupled);
  check_finish(c);
  RandomState s(c), e(c);
  const double dt = 0.02, am = 5.0 / 6, af = 2.0 / 3;
  s.integrator.begin(s.state, dt);
  const Array x = s.values();
  s.integrator.finish(x, e.state);
  const int size = s.random.layout().solid_size();
  expect_newmark(s.state.memory, s.state.memory_rate, e.state.memory, e.state.memory_rate, dt, 2 * size);
  const std::vector<double> u = to_host(s.integrator.stage().displacement), a0 = to_host(s.state.memory),
                            a1 = to_host(e.state.memory), r0 = to_host(s.state.memory_rate),
                            r1 = to_host(e.state.memory_rate);
  for (int k = 0; k < 2 * size; ++k)
    ASSERT_NEAR(c.substrate->branches[k / size].time * ((1 - am) * r0[k] + am * r1[k]),
                u[k % size] - (1 - af) * a0[k] - af * a1[k], 1e-14);
}

}  // namespace
}  // namespace softwet::testing_tools
