// What explicit steps do with displacements, by value: parts of the launches of field/fused.hpp.
#pragma once

#include "field/fused.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// Displacements half way through a step and at its end, at one speed: u = from + dt v and to = u + dt v, for each velocity of a
/// control point of the solid. They are placed in two stages too.
struct MoveMeshes {
  Array to, half_way, end;
  double dt;  ///< half of the step
  ConstArray from, unknown;
  int nodes, apart;  ///< control points of a component of displacement, and from one velocity to the next
  KOKKOS_FUNCTION void operator()(int i) const {
    const int c = (i >= apart ? 1 : 0) + (i >= 2 * apart ? 1 : 0), node = i - c * apart;
    if (node >= nodes) return;
    const double v = unknown(i), u = from(c * nodes + node) + dt * v;
    half_way(c * nodes + node) = u;
    to(c * nodes + node) = end(c * nodes + node) = u + dt * v;
  }
};

/// Rates of displacements: the velocities, by control point of the solid.
struct TakeMotion {
  Array rate;
  ConstArray unknown;
  int components, nodes, apart;
  KOKKOS_FUNCTION void operator()(int node) const {
    for (int c = 0, i = node; c < components; ++c, i += nodes) rate(i) = 0.0 + unknown(c * apart + node);
  }
};

}  // namespace softwet
