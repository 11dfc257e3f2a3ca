// Geometry at a point: the map from reference to current coordinates, and what it does to gradients and measures.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// Identity map: a fixed mesh, or the reference configuration of the solid.
template <class N, int D>
struct FixedPoint {
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& g) const { return g; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const { return f; }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const { return x; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const {
    Vector<N, D> zero;
    for (int i = 0; i < D; ++i) zero[i] = N(0.0);
    return zero;
  }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return N(1.0); }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio_end() const { return N(1.0); }
};

/// Moving map x = X + d(X): F = I + Grad d, cof F = J F^-T.
///   grad_x g = F^-T Grad g,    integral of flux . grad_x q dx = integral of (cof F^T flux) . Grad q dX
template <class N, int D>
struct MovingPoint {
  Matrix<N, D> cofactors;  ///< cof F
  N volume;                ///< J = det F
  N inverse_volume;        ///< 1 / J
  N measure;               ///< J in a volume; |cof F e_D| on a face of the last axis
  N ratio_end;             ///< J(t_{n+1}) / J
  Vector<N, D> velocity;   ///< mesh velocity

  /// @param gradient      F - I at n+af
  /// @param gradient_end  F - I at n+1
  KOKKOS_FORCEINLINE_FUNCTION MovingPoint(const Matrix<N, D>& gradient, const Matrix<N, D>& gradient_end,
                                          const Vector<N, D>& mesh_velocity, bool face)
      : velocity(mesh_velocity) {
    const Matrix<N, D> f = add_diagonal(gradient, 1.0), f_end = add_diagonal(gradient_end, 1.0);
    cofactors = cofactor(f);
    volume = determinant(f, cofactors);
    inverse_volume = 1.0 / volume;
    ratio_end = determinant(f_end, cofactor(f_end)) * inverse_volume;
    measure = volume;
    if (face) {
      Vector<N, D> normal;
      for (int i = 0; i < D; ++i) normal[i] = cofactors(i, D - 1);
      measure = square_root(dot(normal, normal));
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& g) const {
    return inverse_volume * product(cofactors, g);
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const {
    return product(transpose(cofactors), f);
  }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const { return measure * x; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return velocity; }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return volume; }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio_end() const { return ratio_end; }
};

}  // namespace softwet
