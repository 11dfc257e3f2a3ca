// What explicit steps do with displacements, by value: parts of the launches of field/fused.hpp.
#pragma once

#include "field/fused.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// Displacements half way through a step and at its end, at one speed: u = from + dt v and to = u + dt v, by control
/// point of the solid. Both are also stored in the displacements of two stages.
struct MoveMeshes {
  Array to, half_way, end;
  Factor dt;  ///< half of the step
  ConstArray from, unknown;
  int components, nodes, apart;  ///< control points of a component of displacement, and from one velocity to the next

  KOKKOS_FORCEINLINE_FUNCTION void move(int c, int node) const {
    const int i = c * nodes + node;
    const double v = unknown(c * apart + node), u = from(i) + dt * v;
    half_way(i) = u;
    to(i) = end(i) = u + dt * v;
  }
  KOKKOS_FUNCTION void operator()(int node) const {
    for (int c = 0; c < components; ++c) move(c, node);
  }
};

/// MoveMeshes by velocity, for launches that write velocities.
struct MoveMeshesByVelocity {
  MoveMeshes meshes;
  KOKKOS_FUNCTION void operator()(int i) const {
    const int c = i / meshes.apart, node = i % meshes.apart;
    if (node < meshes.nodes) meshes.move(c, node);
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
