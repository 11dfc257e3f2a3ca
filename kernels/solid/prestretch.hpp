// A solid that is stretched before the scene begins.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// The uniform deformation F_0 = diag(l_1, l_2, l_3) from the state in which a material has no stress to the state in
/// which its displacement is 0, and J_0 = det F_0. A law with the energy psi^(F) and the stress P^(F) becomes
///   psi(F) = (psi^(F F_0) - psi^(F_0)) / J_0,   P(F) = P^(F F_0) F_0^T / J_0,
/// both for each volume of the stretched state; P is the derivative of psi. The stress P F^T / J of the deformed state
/// is the stress of the law at F F_0.
/// Source: a change of reference configuration, Ogden, Non-Linear Elastic Deformations, chapter 6 (small on large
/// deformations).
/// Tested: tests/unit/solid/test_prestretch.cpp
struct Prestretch {
  bool acts = false;  ///< false: F_0 = I, and nothing is computed
  /// Stretches l along the axes; the third is 1 in 2D and the stretch around the axis in (r, z).
  Vector<double, 3> stretch{{1, 1, 1}};
  double energy_at_rest = 0;  ///< psi^(F_0)

  KOKKOS_FORCEINLINE_FUNCTION double volume_ratio() const { return stretch[0] * stretch[1] * stretch[2]; }

  /// F F_0 - I of F - I.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M whole(const M& grad_u) const {
    return acts ? with_stretches(times_stretch(grad_u)) : grad_u;
  }
  /// P of P^(F F_0)
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& of_law) const {
    return acts ? (1.0 / volume_ratio()) * times_stretch(of_law) : of_law;
  }
  /// psi of psi^(F F_0)
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const N& of_law) const {
    return acts ? (1.0 / volume_ratio()) * (of_law - energy_at_rest) : of_law;
  }

 private:
  /// A F_0
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> times_stretch(const Matrix<N, D>& a) const {
    Matrix<N, D> r;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) r(i, j) = stretch[j] * a(i, j);
    }
    return r;
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> times_stretch(const AxialMatrix<N>& a) const {
    return {times_stretch(a.plane), stretch[2] * a.hoop};
  }
  /// A + F_0 - I
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> with_stretches(Matrix<N, D> a) const {
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) a(i, i) = a(i, i) + (stretch[i] - 1.0);
    return a;
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> with_stretches(const AxialMatrix<N>& a) const {
    return {with_stretches(a.plane), a.hoop + (stretch[2] - 1.0)};
  }
};

}  // namespace softwet
