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

/// Displacement gradient of the solid at a point; on its top face too, where slopes along the face alone are of use.
template <class N, int D>
struct SolidStrain {
  Matrix<N, D> displacement_gradient;

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return {{Field::displacement, s}, false, true}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidStrain read(const Reader& at) {
    SolidStrain t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      const Vector<N, D> g = at.gradient(i);
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) t.displacement_gradient(i, j) = g[j];
    }
    return t;
  }
};

/// Displacement gradient of the solid and its rate.
template <class N, int D>
struct SolidStrainRate {
  Matrix<N, D> displacement_gradient;
  Matrix<N, D> velocity_gradient;  ///< dv_i/dX_j

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{{Field::displacement, s}, false, true} : Slot{{Field::velocity, s - D}, false, true};
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidStrainRate read(const Reader& at) {
    SolidStrainRate t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      const Vector<N, D> g = at.gradient(i), rate = at.gradient(D + i);
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) {
        t.displacement_gradient(i, j) = g[j];
        t.velocity_gradient(i, j) = rate[j];
      }
    }
    return t;
  }
};

/// Displacement gradient of a solid whose stiffness varies in space.
template <class N, int D>
struct GradedSolidStrain {
  SolidStrain<N, D> strain;
  N stiffness;  ///< over that of the material

  static constexpr int slot_count = D + 1;
  static constexpr Slot slot(int s) { return s < D ? SolidStrain<N, D>::slot(s) : Slot{{Field::given}, true, false}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION GradedSolidStrain read(const Reader& at) {
    return {SolidStrain<N, D>::read(at), at.value(D)};
  }
};

/// Solid at a point where its stiffness varies in space.
template <class N, int D>
struct GradedSolidTrial {
  SolidTrial<N, D> solid;
  N stiffness;  ///< over that of the material

  static constexpr int slot_count = 2 * D + 1;
  static constexpr Slot slot(int s) {
    return s < 2 * D ? SolidTrial<N, D>::slot(s) : Slot{{Field::given}, true, false};
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION GradedSolidTrial read(const Reader& at) {
    return {SolidTrial<N, D>::read(at), at.value(2 * D)};
  }
};

}  // namespace softwet
