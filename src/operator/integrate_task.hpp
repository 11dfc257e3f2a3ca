// A functional on a region, and what it sees at a point.
#pragma once

#include "operator/batch.hpp"

namespace softwet {

/// Like Task, for a functional: no tangent, no test functions.
template <int D, class Functional, class Motion>
struct ReduceTask {
  using Trial = typename Functional::template Trial<double, D>;

  Region<D> region;
  Functional functional;
  Motion motion;
  const double* slot[Trial::slot_count];
  double scale[Trial::slot_count] = {};
  const double* memory = nullptr;  ///< of the points
};

/// Values of fields that do not move, as numbers whose tangent is zero.
template <class Fields, class N>
struct LiftedFields {
  const Fields& fields;
  KOKKOS_FORCEINLINE_FUNCTION N number(int s, int c, int q) const {
    if constexpr (is_dual<N>) {
      return N(fields.number(s, c, q), 0.0);
    } else {
      return fields.number(s, c, q);
    }
  }
};

}  // namespace softwet
