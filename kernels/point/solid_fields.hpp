// Bundles of the terms of the solid.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// Solid at a point; gradients are with respect to X.
template <class N, int D, class M = Matrix<N, D>>
struct SolidTrial {
  Vector<N, D> acceleration;
  M displacement_gradient;  ///< (Grad u)_ij = du_i/dX_j

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{{Field::acceleration, s}, true, false} : gradient_slot<M>(Field::displacement, s - D);
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidTrial read(const Reader& at) {
    SolidTrial t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) t.acceleration[i] = at.value(i);
    t.displacement_gradient = gradient_of<M, N, D>(at, D);
    return t;
  }
};

/// Displacement gradient of the solid at a point; on its top face too, where slopes along the face alone are of use.
template <class N, int D, class M = Matrix<N, D>>
struct SolidStrain {
  M displacement_gradient;

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return gradient_slot<M>(Field::displacement, s); }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidStrain read(const Reader& at) {
    return {gradient_of<M, N, D>(at, 0)};
  }
};

/// Displacement gradient of the solid and its rate.
template <class N, int D, class M = Matrix<N, D>>
struct SolidStrainRate {
  M displacement_gradient;
  M velocity_gradient;  ///< dv_i/dX_j

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return gradient_slot<M>(s < D ? Field::displacement : Field::velocity, s < D ? s : s - D);
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidStrainRate read(const Reader& at) {
    return {gradient_of<M, N, D>(at, 0), gradient_of<M, N, D>(at, D)};
  }
};

}  // namespace softwet
