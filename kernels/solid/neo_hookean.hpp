// Compressible neo-Hookean material.
#pragma once

#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// Energy G (tr(F^T F) - D)/2 - G ln J + lambda (ln J)^2/2 with F = I + Grad u, J = det F; it grows beyond all bounds
/// where the solid is squeezed to nothing, so the material stays stiff under compression. 2D: plane strain.
/// Source: Bonet and Wood 2008, eq. (6.27).   Tested: tests/unit/solid/test_neo_hookean.cpp
struct NeoHookean : LameParameters {
  static constexpr const char* name = "neo_hookean";

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M strain(const M& grad_u) const {
    return green_lagrange_strain(grad_u);
  }

  /// First Piola-Kirchhoff stress P = G (F - F^-T) + lambda ln J F^-T, shape (D, D), scale a b^2.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    const M f = add_diagonal(grad_u, 1.0), cof = cofactor(f);
    const auto j = determinant(f, cof);
    const auto factor = (lambda * logarithm(j) - shear_modulus) / j;
    return shear_modulus * f + factor * cof;
  }

  /// Stored energy per reference volume, scale a b^2.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy(const M& grad_u) const {
    // tr(F^T F) - D = 2 tr(Grad u) + Grad u : Grad u
    const auto log_j = logarithm(volume_ratio(grad_u));
    return (0.5 * shear_modulus) * (2.0 * trace(grad_u) + contract(grad_u, grad_u)) - shear_modulus * log_j +
           (0.5 * lambda) * (log_j * log_j);
  }
};

}  // namespace softwet
