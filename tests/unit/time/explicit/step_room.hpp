// The largest stable step of the linearised scheme, found by trying, over the bound of the step.
#pragma once

#include "time/explicit/step_bound.hpp"
#include "unit/time/explicit_run.hpp"

namespace softwet::testing_tools {

/// Whether differences between two runs from states that hardly differ grow in many steps of the same frozen length.
inline bool grows(const Case& c, TimeScheme scheme, MassKind kind, double dt) {
  ExplicitRun base(c, scheme, kind), moved(c, scheme, kind);
  constexpr double small = 1e-9;
  std::vector<double> v = to_host(moved.state.unknown);
  const std::vector<double> mask = to_host(moved.scene.mask());
  const int nv = moved.system.velocities();
  unsigned seed = 1;
  for (int i = 0; i < nv; ++i)
    v[i] += small * mask[i] * (((seed = seed * 1103515245u + 12345u) >> 16) % 1000 / 500.0 - 1);
  Kokkos::deep_copy(moved.state.unknown, to_device<Array>(v));
  EXPECT_TRUE(moved.step->begin(moved.state).empty());
  const StepRates rates = base.rates();
  constexpr int steps = 90;
  for (int n = 0; n < steps; ++n)
    for (ExplicitRun* run : {&base, &moved}) {
      if (!run->step->advance(run->state.time, dt, rates).empty()) return true;
      run->step->accept(run->state.time + dt, dt, run->state, run->before);
    }
  const double now = root_of_squares(base.state.unknown, moved.state.unknown, 0, nv);
  return !(now < 100 * small);
}

/// The measured limit over the limit by the bound, by bisection.
inline double room(const Case& c, TimeScheme scheme, MassKind kind = MassKind::corrected) {
  const double bound = 1 / ExplicitRun(c, scheme, kind).rates().combined;
  double low = 0.5, high = 3;
  while (high / low > 1.02) {
    const double middle = std::sqrt(low * high);
    (grows(c, scheme, kind, middle * bound) ? high : low) = middle;
  }
  std::printf("  %s: the limit is %.2f of the bound\n", word_of(scheme).c_str(), low);
  return low;
}

}  // namespace softwet::testing_tools
