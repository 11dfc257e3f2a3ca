// Scenes whose solid is stretched before they begin.
#pragma once

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

inline Case stretched(Case c, std::vector<double> along, MaterialModel material = MaterialModel::neo_hookean) {
  c.substrate->prestretch = std::move(along);
  c.substrate->material = material;
  return c;
}

/// The largest residual where nothing moves and no load acts.
template <int D>
double largest_at_rest(Case c) {
  c.loads.clear();
  RandomSceneIn<D> s(c);
  Stage stage = s.stage();
  for (Array* field : {&stage.unknown, &stage.acceleration, &stage.displacement, &stage.displacement_end})
    Kokkos::deep_copy(*field, 0.0);
  const std::vector<double> r = s.residual(stage);
  double largest = 0;
  for (const double x : r) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace softwet::testing_tools
