// The first steps of a run, before a test looks at one.
#pragma once

#include "scene/initial.hpp"
#include "time/stepper.hpp"

namespace softwet::testing_tools {

template <int D>
void take_first_steps(Stepper<D, 2>& stepper, const Scene<D, 2>& scene, const Case& c) {
  State state = initial_state<D, 2>(c, scene);
  stepper.scheme().initialise(state);
  stepper.start(state);
  for (int i = 0; i < 3; ++i) stepper.step();
}

}  // namespace softwet::testing_tools
