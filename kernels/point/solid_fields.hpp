// Bundles of the terms of the solid.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// Solid at a point; gradients are with respect to X.
template <class N, int D>
struct SolidTrial {
  Vector<N, D> acceleration;
  Matrix<N, D> displacement_gradient;  ///< (Grad u)_ij = du_i/dX_j

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{{Field::acceleration, s}, true, false} : Slot{{Field::displacement, s - D}, false, true};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidTrial read(const Reader& at) {
    SolidTrial t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      t.acceleration[i] = at.value(i);
      const Vector<N, D> g = at.gradient(D + i);
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) t.displacement_gradient(i, j) = g[j];
    }
    return t;
  }
};

}  // namespace softwet
