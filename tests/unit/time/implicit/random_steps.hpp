// Steps of generalized-alpha from states whose levels are all random.
#pragma once

#include "time/implicit/generalized_alpha.hpp"

#include "unit/scene/branch_checks.hpp"

namespace softwet::testing_tools {

/// A scene with a state whose levels are all random.
struct RandomState {
  RandomScene random;
  GeneralizedAlpha<2, 2> integrator;
  State state;

  explicit RandomState(const Case& c) : random(c), integrator(random.scene, 0.5) {
    const Stage& s = random.stage();
    Patch<2>& p = random.terms.patch;
    state = {3.0,
             s.unknown,
             s.acceleration,
             s.displacement,
             p.draw(random.layout().solid_size(), -0.3, 0.3),
             p.draw(random.layout().scalar_size(), 0.0, 0.01),
             p.draw(random.layout().scalar_size(), -0.01, 0.01)};
    if (random.layout().branches == 0) return;
    state.memory = p.draw(random.layout().memory_size(), -0.01, 0.01);
    state.memory_rate = p.draw(random.layout().memory_size(), -0.3, 0.3);
  }
  /// Admissible values for the middle of a step.
  Array values() {
    RandomScene other(random.data);
    std::vector<double> x = to_host(other.stage().unknown), noise = to_host(random.direction());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += 0.05 * noise[i];
    return to_device<Array>(x);
  }
};

/// A scene that keeps the rates of the density at the wall.
inline Case scene_with_rates(SceneKind kind, bool periodic = false) {
  Case c = small_case(kind, WallLaw::energy, periodic);
  c.fluid->line_friction = 0.3;
  c.fluid->contact_angle_range = {50, 70};
  c.fluid->contact_angle = c.fluid->middle_of_range();
  c.fluid->creep_speed = 0.5;
  return c;
}

/// A viscoelastic solid: one branch is slower than a step, the other one faster.
inline Case scene_with_branches(SceneKind kind, Strain strain = Strain::small) {
  Case c = small_case(kind);
  c.substrate->strain = strain;
  c.substrate->branches = {{0.9, 0.3}, {1.7, 0.004}};
  return c;
}

}  // namespace softwet::testing_tools
