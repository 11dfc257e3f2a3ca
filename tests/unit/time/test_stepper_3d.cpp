// Steps in 3D: a scene that does not change along y is the 2D scene.
#include "scene/initial.hpp"
#include "time/stepper.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

Case driven_3d(Case c) {
  c.loads[0].start = 0;
  c.loads[0].ramp = 1;
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = 0.05;
  c.time.tolerance = 1e30;
  c.solver.newton_rtol = 1e-10;
  c.solver.newton_atol = 1e-13;
  c.solver.krylov_rtol = 1e-4;
  c.solver.precision = PrecisionChoice::full;
  c.solver.newton_max = 30;
  c.domain.elements.front() = 5;
  c.droplets = {};
  Droplet drop;
  drop.centre.assign(c.dimension(), 0.25);
  drop.centre.front() = 0.45;
  drop.centre.back() = 0.6;
  drop.radius = 0.25;
  drop.stretch.assign(c.dimension(), 1.0);
  if (c.dimension() == 3) drop.stretch[1] = 1e6;  // a cylinder along y
  c.droplets.push_back(drop);
  return c;
}

/// The state after three steps, and how the mass has changed.
template <int D>
State advance(const Case& c, const Scene<D, 2>& scene) {
  Stepper<D, 2> stepper(scene, c, {});
  State state = initial_state<D, 2>(c, scene);
  stepper.scheme().initialise(state);
  const double mass = scene.balance().measure(stage_at(scene.layout(), state)).integrals["mass"];
  stepper.start(state);
  for (int n = 0; n < 3; ++n) stepper.step();
  EXPECT_NEAR(scene.balance().measure(stage_at(scene.layout(), stepper.state())).integrals["mass"] / mass, 1, 1e-12);
  return stepper.state();
}

/// max |a(i, j, k) - b(i, k)| over all planes j, over max |b|; n: functions along x and y.
double apart(const std::vector<double>& a, const std::vector<double>& b, int nx, int ny) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t x = i % nx, z = i / nx / ny;
    worst = std::max(worst, std::abs(a[i] - b[z * nx + x]));
  }
  return worst / largest(b);
}

TEST(Stepper3D, ASceneThatDoesNotChangeAlongYIsTheOneInThePlane) {
  const Case flat_case = driven_3d(small_case(SceneKind::coupled)),
             deep_case = driven_3d(small_case_in_3d(SceneKind::coupled));
  const Scene<2, 2> flat(flat_case);
  const Scene<3, 2> deep(deep_case);
  const State a = advance<3>(deep_case, deep), b = advance<2>(flat_case, flat);
  const Layout<3>& l = deep.layout();
  const Layout<2>& m = flat.layout();
  const int nx = l.axis[0].functions(), ny = l.axis[1].functions();
  const auto cut = [](const Array& v, int first, int count) { return to_host(part(v, first, first + count)); };
  const auto compare = [&](const char* name, int of_deep, int of_flat, int count) {
    const std::vector<double> flat_values = cut(b.unknown, of_flat, count);
    EXPECT_GT(largest(flat_values), 1e-6) << name;
    EXPECT_LT(apart(cut(a.unknown, of_deep, count * ny), flat_values, nx, ny), 1e-7) << name;
  };
  compare("velocity along x", l.velocity_offset(0), m.velocity_offset(0), m.velocity_size() / 2);
  compare("velocity along z", l.velocity_offset(2), m.velocity_offset(1), m.velocity_size() / 2);
  compare("density", l.density_offset(), m.density_offset(), m.scalar_size());
  compare("potential", l.potential_offset(), m.potential_offset(), m.scalar_size());
  EXPECT_LT(largest(cut(a.unknown, l.velocity_offset(1), l.velocity_size() / 3)), 1e-10) << "velocity along y";
}

}  // namespace
}  // namespace softwet::testing_tools
