// Steps of an explicit scheme on a small scene, for tests.
#pragma once

#include "scene/initial.hpp"
#include "time/explicit/kick_drift.hpp"
#include "time/explicit/runge_kutta_step.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

/// A droplet that begins to move.
inline Case moving_droplet(SceneKind kind, bool periodic = false) {
  Case c = small_case(kind, WallLaw::energy, periodic);
  c.domain.elements = {18, 12};
  for (Load& load : c.loads) load.start = 0;
  if (c.fluid) {
    c.fluid->viscosity = 2e-3;
    c.fluid->capillarity = 0.1;
    c.fluid->stabilisation = 0.0;
    c.droplets = {{{0.45, kind == SceneKind::coupled ? 0.8 / 3 : 0.0}, 0.3}};
  }
  return c;
}

/// The case in the coordinates (r, z), with the droplet on the axis.
inline Case around_axis(Case c) {
  for (Droplet& droplet : c.droplets) droplet.centre[0] = 0;
  return axisymmetric(c);
}

/// A scene with one of the explicit steps, at its first state.
template <int D>
struct ExplicitRunIn {
  Scene<D, 2> scene;
  SemiDiscrete<D, 2> system;
  std::unique_ptr<ExplicitStep<D, 2>> step;
  StepBound<D, 2> bound;
  State state;
  Array before;

  ExplicitRunIn(const Case& c, TimeScheme scheme, MassKind kind = MassKind::corrected)
      : scene(c),
        system(scene, kind),
        step(make(scheme)),
        bound(scene.regions(), scene.coefficients(), kind, step->formula()),
        state(initial_state<D, 2>(c, scene)),
        before("before", scene.layout().size()) {
    system.set_moments(state);
    EXPECT_TRUE(step->begin(state).empty());
  }
  StepRates rates() const {
    return bound.rates(
        {system.stage().unknown, system.stage().displacement, step->moments(), system.masses().scalar_sums()});
  }
  void run(double dt, int steps) {
    for (int n = 0; n < steps; ++n) {
      ASSERT_TRUE(step->advance(state.time, dt, rates()).empty());
      step->accept(state.time + dt, dt, state, before);
    }
  }

 private:
  std::unique_ptr<ExplicitStep<D, 2>> make(TimeScheme scheme) {
    if (scheme == TimeScheme::kick_drift) return std::make_unique<KickDrift<D, 2>>(system);
    return std::make_unique<RungeKuttaStep<D, 2>>(system,
                                                  scheme == TimeScheme::rkl2 ? Viscosity::apart : Viscosity::among_all);
  }
};
using ExplicitRun = ExplicitRunIn<2>;

inline double root_of_squares(const Array& a, const Array& b, int first, int last) {
  const std::vector<double> x = to_host(a), y = to_host(b);
  double sum = 0;
  for (int i = first; i < last; ++i) sum += (x[i] - y[i]) * (x[i] - y[i]);
  return std::sqrt(sum / (last - first));
}

}  // namespace softwet::testing_tools
