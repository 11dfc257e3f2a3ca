// Equal explicit steps, recorded and started kernel by kernel.
#pragma once

#include <gtest/gtest.h>

#include "time/explicit/explicit_scheme.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet::testing_tools {

/// A run whose steps have lengths of a list, in turn, in shares of the longest stable one.
template <int D>
struct RunOfSteps {
  Case c;
  Scene<D, 2> scene;
  Stepper<D, 2> stepper;
  double longest = 0;
  int taken = 0;
  std::vector<double> indicators;

  RunOfSteps(Case of, Launch launch) : c(with_launch(std::move(of), launch)), scene(c), stepper(scene, c, {}) {
    take_first_steps(stepper, scene, c);
    longest = 0.9 / scheme().rates().combined;
  }
  static Case with_launch(Case c, Launch launch) {
    c.time.scheme = TimeScheme::kick_drift;
    c.time.tolerance = 1;
    c.time.end = 100;
    c.solver.launch = launch;
    return c;
  }
  const ExplicitScheme<D, 2>& scheme() { return dynamic_cast<const ExplicitScheme<D, 2>&>(stepper.scheme()); }
  void step(int count) {
    constexpr double share[] = {0.5, 0.7, 0.3, 0.6, 0.45};
    for (int i = 0; i < count; ++i) {
      stepper.control().set_proposed(share[taken++ % 5] * longest);
      indicators.push_back(stepper.step().indicator);
    }
  }
  std::vector<std::vector<double>> numbers() const {
    const State& s = const_cast<Stepper<D, 2>&>(stepper).state();
    std::vector<std::vector<double>> all{{s.time}, indicators};
    for (const Array& a : {s.unknown, s.velocity_rate, s.displacement, s.displacement_rate, s.moment, s.moment_rate,
                           s.memory, s.memory_rate})
      all.push_back(to_host(a));
    return all;
  }
};

/// Runs equal steps of a case, recorded and not. @return recordings at the end
template <int D>
int recordings_with_same_bits(const Case& c, int steps = 11) {
  RunOfSteps<D> plain(c, Launch::kernels), recorded(c, Launch::graph);
  plain.step(steps);
  recorded.step(steps);
  EXPECT_EQ(plain.scheme().recordings(), 0);
  EXPECT_EQ(plain.numbers(), recorded.numbers());
  return recorded.scheme().recordings();
}

/// Where nothing is recorded, as on a processor: none.
inline int two() { return host_algorithms ? 0 : 2; }

}  // namespace softwet::testing_tools
