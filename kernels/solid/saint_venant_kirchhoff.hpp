// Saint Venant-Kirchhoff material, and Hooke's as its limit of small strain.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// S = lambda tr(E) I + 2 G E,  E = (F^T F - I)/2,  F = I + Grad u; energy lambda tr(E)^2/2 + G E:E. 2D: plane strain.
/// With small strain E = (Grad u + Grad u^T)/2 and P = S: linear elasticity.
/// Source: Bueno et al. 2017, eq. (2).   Tested: tests/unit/solid/test_saint_venant_kirchhoff.cpp
struct SaintVenantKirchhoff {
  double lambda = 0;         ///< first Lame parameter, scale a b^2
  double shear_modulus = 0;  ///< G, scale a b^2
  bool small_strain = false;

  /// @param young    Young modulus, scale a b^2 (rho_0^s * E_hat)
  /// @param poisson  nu in (-1, 1/2)
  static SaintVenantKirchhoff from(double young, double poisson, bool small_strain = false) {
    return {poisson * young / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson)), small_strain};
  }

  /// E from Grad u, shape (D, D).
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> strain(const Matrix<N, D>& grad_u) const {
    if (small_strain) return 0.5 * (grad_u + transpose(grad_u));
    Matrix<N, D> e;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        N quadratic = grad_u(0, i) * grad_u(0, j);
        for (int k = 1; k < D; ++k) quadratic = quadratic + grad_u(k, i) * grad_u(k, j);
        e(i, j) = 0.5 * (grad_u(i, j) + grad_u(j, i) + quadratic);
      }
    return e;
  }

  /// J = det F, deformed over reference volume.
  template <class N, int D>
  static KOKKOS_FORCEINLINE_FUNCTION N volume_ratio(const Matrix<N, D>& grad_u) {
    const Matrix<N, D> f = add_diagonal(grad_u, 1.0);
    return determinant(f, cofactor(f));
  }

  /// First Piola-Kirchhoff stress P = F S, shape (D, D).
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> first_piola(const Matrix<N, D>& grad_u) const {
    const Matrix<N, D> e = strain(grad_u);
    const Matrix<N, D> s = add_diagonal((2.0 * shear_modulus) * e, lambda * trace(e));
    return small_strain ? s : s + product(grad_u, s);
  }

  /// Cauchy stress P F^T / J, and P with small strain. Plane strain has a stress along the third axis too: give Grad u with shape (3, 3).
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, 3> cauchy(const Matrix<N, 3>& grad_u) const {
    const Matrix<N, 3> p = first_piola(grad_u);
    if (small_strain) return p;
    return (1.0 / volume_ratio(grad_u)) * (p + product(p, transpose(grad_u)));
  }

  /// Stored energy per reference volume, scale a b^2.
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const Matrix<N, D>& grad_u) const {
    const Matrix<N, D> e = strain(grad_u);
    const N tr = trace(e);
    return (0.5 * lambda) * (tr * tr) + shear_modulus * contract(e, e);
  }
};

}  // namespace softwet
