// A term on a region as tiles have it: plain numbers and pointers alone, so that its bytes can be copied to a device.
#pragma once

#include "operator/device/tile_plan.hpp"
#include "operator/device/tile_team.hpp"

namespace softwet {

/// The tables of an axis, as in AxisRuleOf.
template <class Real>
struct AxisTables {
  const Real *values, *slopes, *weights, *positions, *shares;
  const int* first_functions;
  int functions, stored;  ///< of an element; elements in the tables

  static AxisTables of(const AxisRuleOf<Real>& rule) {
    return {rule.value.data(),
            rule.slope.data(),
            rule.weight.data(),
            rule.position.data(),
            rule.share.data(),
            rule.first.data(),
            static_cast<int>(rule.value.extent(1)),
            static_cast<int>(rule.value.extent(2))};
  }
  KOKKOS_FORCEINLINE_FUNCTION Real value(int q, int a, int e) const {
    return constant(values + ((q * functions + a) * stored + e));
  }
  KOKKOS_FORCEINLINE_FUNCTION Real slope(int q, int a, int e) const {
    return constant(slopes + ((q * functions + a) * stored + e));
  }
  KOKKOS_FORCEINLINE_FUNCTION Real weight(int q, int e) const { return constant(weights + (q * stored + e)); }
  KOKKOS_FORCEINLINE_FUNCTION Real position(int q, int e) const { return constant(positions + (q * stored + e)); }
  KOKKOS_FORCEINLINE_FUNCTION Real share(int e) const { return constant(shares + e); }
};

/// Where a product finds its tangents in the vector that it multiplies: control value (0, 0, 0) of each unknown, and
/// the first one in the wall's row of each velocity.
template <int D>
struct Tangents {
  int of_unknown[D + 2], of_wall[D];
  int moves;  ///< 1: the mesh has tangents too

  template <class Term, class Motion, class Real>
  static Tangents of(const Task<D, Term, Motion, Real>& task, const Real* direction) {
    Tangents t{};
    for (int u = 0; u < D + 2; ++u)
      if (task.tangent[u]) t.of_unknown[u] = static_cast<int>(task.tangent[u] - direction);
    if constexpr (!std::is_same_v<Motion, NoMotion>) {
      t.moves = task.motion.tangent[0] ? 1 : 0;
      for (int d = 0; d < D && t.moves; ++d) t.of_wall[d] = static_cast<int>(task.motion.tangent[d] - direction);
    }
    return t;
  }
};

/// What a Task has but the tangents themselves.
template <class Plan>
struct TileTask {
  using Real = typename Plan::Real;
  static constexpr int D = Plan::D;

  AxisTables<Real> axis[D], test;
  int stride[D];
  typename Plan::Term term;
  typename Plan::Motion motion;
  const Real* slot[Plan::slots];
  Real scale[Plan::slots];
  const Real* memory;  ///< of the points
  Real factor;
  Tangents<D> tangents;

  /// Writes member by member, and nothing between them, so that terms can be compared byte by byte.
  void set(const Task<D, typename Plan::Term, typename Plan::Motion, Real>& from, const Real* direction) {
    for (int d = 0; d < D; ++d) {
      axis[d] = AxisTables<Real>::of(from.region.axis[d]);
      stride[d] = from.region.stride[d];
    }
    test = AxisTables<Real>::of(from.region.test);
    term = from.term;
    for (int s = 0; s < Plan::slots; ++s) {
      slot[s] = from.slot[s];
      scale[s] = from.scale[s];
    }
    memory = from.memory;
    factor = from.factor;
    tangents = Tangents<D>::of(from, direction);
    if constexpr (Plan::moves) {
      for (int d = 0; d < D; ++d) {
        motion.displacement[d] = from.motion.displacement[d];
        motion.velocity[d] = from.motion.velocity[d];
        motion.tangent[d] = nullptr;
      }
      motion.scale = from.motion.scale;
      motion.blend = from.motion.blend;
    }
  }
};

}  // namespace softwet
