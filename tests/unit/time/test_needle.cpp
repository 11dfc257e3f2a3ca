// A layer that a needle holds in all of it and that slips over its bottom: after a jump of the needle by U it swings as
// a whole, u = U (1 - cos(w t)), w = sqrt(k/rho_0). All schemes are of second order here, and the energy stays.
#include "unit/time/explicit_run.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet::testing_tools {
namespace {

constexpr double jump = 0.02, stiffness = 60, end_of_swing = 0.5;

Case held_layer() {
  Case c = small_case(SceneKind::solid, WallLaw::energy, true);
  c.loads.clear();
  c.domain.elements = {8, 4};
  c.needles = {{{0, 0}, c.domain.size, stiffness, {jump, 0}}};
  c.time.rho_inf = 1;
  c.time.tolerance = 1e30;
  c.solver.newton_rtol = 1e-12;
  c.solver.krylov_rtol = 1e-6;
  return c;
}
double frequency(const Case& c) { return std::sqrt(stiffness / c.substrate->density); }
double exact(const Case& c, double t) { return jump * (1 - std::cos(frequency(c) * t)); }

/// Largest difference of a displacement along x from the exact one, of all that are stored once; that along y is 0.
double error_of(const Case& c, const Layout<2>& l, const State& state) {
  const std::vector<double> u = to_host(state.displacement);
  double error = 0;
  for (int i = 0; i < l.solid_rows() * l.row_size; ++i) {
    if (i % l.row_size >= l.axis[0].owned()) continue;
    error = std::max({error, std::abs(u[i] - exact(c, state.time)), std::abs(u[l.displacement_offset(1) + i])});
  }
  return error;
}

double implicit_error(int steps) {
  Case c = held_layer();
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = end_of_swing / steps;
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  State state = initial_state<2, 2>(c, scene);
  stepper.scheme().initialise(state);
  stepper.start(state);
  for (int n = 0; n < steps; ++n) stepper.step();
  return error_of(c, scene.layout(), stepper.state());
}

double explicit_error(TimeScheme scheme, MassKind kind, int steps) {
  const Case c = held_layer();
  ExplicitRun run(c, scheme, kind);
  run.run(end_of_swing / steps, steps);
  const double energy = run.scene.balance().measure(stage_at(run.scene.layout(), run.state)).integrals.energy();
  const double first = 0.5 * stiffness * jump * jump * c.domain.size[0] * c.domain.size[1];
  EXPECT_NEAR(energy, first, 0.02 * first) << word_of(scheme);
  return error_of(c, run.scene.layout(), run.state);
}

TEST(Needle, ALayerSwingsAsAWholeWithImplicitSteps) {
  const double a = implicit_error(40), b = implicit_error(80);
  std::printf("  errors with 40 and 80 steps: %.2e %.2e\n", a, b);
  EXPECT_LT(b, 0.02 * jump);
  EXPECT_NEAR(std::log2(a / b), 2, 0.2);
}

TEST(Needle, ALayerSwingsAsAWholeWithExplicitSteps) {
  for (const MassKind kind : {MassKind::lumped, MassKind::corrected, MassKind::consistent}) {
    const double a = explicit_error(TimeScheme::kick_drift, kind, 40),
                 b = explicit_error(TimeScheme::kick_drift, kind, 80);
    std::printf("  errors with 40 and 80 steps: %.2e %.2e\n", a, b);
    EXPECT_LT(b, 0.01 * jump);
    EXPECT_NEAR(std::log2(a / b), 2, 0.2);
  }
  EXPECT_LT(explicit_error(TimeScheme::ssp_rk3, MassKind::lumped, 80), 1e-4 * jump);
}

// A rigid needle that jumps: what Newton's method leaves is small where nothing is held, too. It is as small as the
// default tolerance, 1e-3, for each of three steps; of the residual with the stiff springs, 1e-3 would leave 0.4 here.
TEST(Needle, AStiffOneDoesNotLoosenTheRest) {
  std::vector<std::vector<double>> found;
  for (const double rtol : {1e-3, 1e-11}) {
    Case c = small_case(SceneKind::solid);
    c.loads.clear();
    c.substrate->strain = Strain::small;
    c.boundary.side[1][0] = Side::clamped;
    c.needles = {{{0.3, 0.4}, {0.6, 0.8}, 1e6, {0.02, -0.01}}};
    c.time.dt_initial = c.time.dt_min = c.time.dt_max = 0.02;
    c.time.tolerance = 1e30;
    c.solver.newton_rtol = rtol;
    const Scene<2, 2> scene(c);
    Stepper<2, 2> stepper(scene, c, {});
    take_first_steps(stepper, scene, c);
    found.push_back(to_host(stepper.state().displacement));
    EXPECT_EQ(stepper.counts().rejected_newton, 0);
  }
  const double difference = distance(found[0], found[1]);
  std::printf("  displacements differ by %.1e\n", difference);
  EXPECT_LT(difference, 3e-3);
}

}  // namespace
}  // namespace softwet::testing_tools
