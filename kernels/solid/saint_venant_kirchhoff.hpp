// Saint Venant-Kirchhoff material.
#pragma once

#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// S = lambda tr(E) I + 2 G E of the Green-Lagrange strain E; energy lambda tr(E)^2/2 + G E : E. 2D: plane strain.
/// Source: Bueno et al. 2017, eq. (2).   Tested: tests/unit/solid/test_saint_venant_kirchhoff.cpp
struct SaintVenantKirchhoff : LameParameters {
  static constexpr const char* name = "saint_venant_kirchhoff";

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M strain(const M& grad_u) const {
    return green_lagrange_strain(grad_u);
  }

  /// First Piola-Kirchhoff stress P = F S, shape (D, D), scale a b^2.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    const M s = linear_stress(*this, strain(grad_u));
    return s + product(grad_u, s);
  }

  /// Stored energy per reference volume, scale a b^2.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy(const M& grad_u) const {
    return quadratic_energy(*this, strain(grad_u));
  }
};

}  // namespace softwet
