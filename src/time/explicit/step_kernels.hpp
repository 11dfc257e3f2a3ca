// What explicit steps do with vectors, by value: parts of the launches of field/fused.hpp.
#pragma once

#include "field/fused.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// A sum of vectors, which is placed in a second one too.
struct Kick {
  SumOf sum;
  Array placed;
  KOKKOS_FUNCTION void operator()(int i) const {
    sum(i);
    placed(i) = sum.y(i);
  }
};

/// Displacements to = from + dt v, which are placed in the stage too, by control point of the solid.
struct MoveMesh {
  Array to, placed;
  double dt;
  ConstArray from, unknown;
  int components, nodes, apart;  ///< control points of a component of displacement, and from one velocity to the next
  KOKKOS_FUNCTION void operator()(int node) const {
    for (int c = 0, i = node; c < components; ++c, i += nodes) {
      const double u = from(i) + dt * unknown(c * apart + node);
      to(i) = placed(i) = u;
    }
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

/// rates = 0 - mask force, and of the force zero is left. It is +0 where the mask is 0, whatever sign the force has there:
/// ghosts have the same bits in any number of processes.
struct TakeRates {
  Array rates, force;
  ConstArray mask;
  KOKKOS_FUNCTION void operator()(int i) const {
    rates(i) = 0.0 - mask(i) * force(i);
    force(i) = 0;
  }
};

}  // namespace softwet
