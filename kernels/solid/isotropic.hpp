// What the materials of the solid share: their two parameters, the strain, and the stress in the deformed state.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// Parameters of an isotropic elastic solid, scale a b^2.
struct LameParameters {
  double lambda = 0;         ///< first Lame parameter
  double shear_modulus = 0;  ///< G

  /// @param young    Young modulus, scale a b^2 (rho_0^s * E_hat)
  /// @param poisson  nu in (-1, 1/2)
  static LameParameters from(double young, double poisson) {
    return {poisson * young / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
  }
};

/// A nearly incompressible solid in two parts that add up to it. The first is integrated as usual, with a first Lame
/// parameter of at most nu = 0.4. The second has the rest of that parameter alone, for the mean of the displacement
/// gradient over an element. Splines have two displacements for each element in 2D and do not lock under the second
/// part; the first part resists every deformation whose means are zero. Measured: docs/limits.md.
/// Tested: tests/unit/solid/test_selective.cpp
struct SelectiveParts {
  static constexpr double poisson = 0.4;

  LameParameters everywhere, of_means;

  static SelectiveParts of(const LameParameters& whole) {
    const double most = 2 * poisson / (1 - 2 * poisson) * whole.shear_modulus;
    const double lambda = whole.lambda < most ? whole.lambda : most;
    return {{lambda, whole.shear_modulus}, {whole.lambda - lambda, 0}};
  }
};

/// Green-Lagrange strain E = (F^T F - I)/2 with F = I + Grad u, shape (D, D). 2D: plane strain.
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> green_lagrange_strain(const Matrix<N, D>& grad_u) {
  Matrix<N, D> e;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      N quadratic = grad_u(0, i) * grad_u(0, j);
      for (int k = 1; k < D; ++k) quadratic = quadratic + grad_u(k, i) * grad_u(k, j);
      e(i, j) = 0.5 * (grad_u(i, j) + grad_u(j, i) + quadratic);
    }
  return e;
}

/// Green-Lagrange strain in the coordinates (r, z), where F has the hoop entry 1 + u_r / r.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> green_lagrange_strain(const AxialMatrix<N>& grad_u) {
  return {green_lagrange_strain(grad_u.plane), grad_u.hoop + 0.5 * (grad_u.hoop * grad_u.hoop)};
}

/// E' = sym(F^T Grad v), the rate of the Green-Lagrange strain; Grad v counts `finite` times in its quadratic part,
/// which small strains leave out.
template <class M>
KOKKOS_FORCEINLINE_FUNCTION M green_lagrange_rate(const M& grad_u, const M& grad_v, double finite = 1) {
  const M g = grad_v + finite * product(transpose(grad_u), grad_v);
  return 0.5 * (g + transpose(g));
}

/// J = det F, deformed over reference volume.
template <class M>
KOKKOS_FORCEINLINE_FUNCTION auto volume_ratio(const M& grad_u) {
  const M f = add_diagonal(grad_u, 1.0);
  return determinant(f, cofactor(f));
}

/// lambda tr(E) I + 2 G E, the stress of Hooke's law for a strain E; scale a b^2.
template <class M>
KOKKOS_FORCEINLINE_FUNCTION M linear_stress(const LameParameters& m, const M& e) {
  return add_diagonal((2.0 * m.shear_modulus) * e, m.lambda * trace(e));
}

/// lambda tr(E)^2/2 + G E : E, its energy; scale a b^2.
template <class M>
KOKKOS_FORCEINLINE_FUNCTION auto quadratic_energy(const LameParameters& m, const M& e) {
  const auto tr = trace(e);
  return (0.5 * m.lambda) * (tr * tr) + m.shear_modulus * contract(e, e);
}

/// Cauchy stress P F^T / J of a first Piola-Kirchhoff stress P. Plane strain has a stress along the third axis too:
/// give both with shape (3, 3).
template <class N>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, 3> cauchy_stress(const Matrix<N, 3>& p, const Matrix<N, 3>& grad_u) {
  return (1.0 / volume_ratio(grad_u)) * (p + product(p, transpose(grad_u)));
}

}  // namespace softwet
