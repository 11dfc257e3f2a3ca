// Newtonian viscous stress.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// tau = m (grad v + grad v^T) - (2/3) m div v I        shape (D, D), symmetric, scale a b^2
/// @param viscosity  m = mu_hat
/// @param grad_v     (grad v)_ij = dv_i/dx_j, scale sqrt(ab)/L0. In 2D the motion is plane: dv_z = 0.
/// Source: Bueno et al. 2017, eq. (4) with the Stokes hypothesis.   Tested: tests/unit/fluid/test_newtonian.cpp
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> newtonian_stress(double viscosity, const Matrix<N, D>& grad_v) {
  Matrix<N, D> tau;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) tau(i, j) = viscosity * (grad_v(i, j) + grad_v(j, i));
  return add_diagonal(tau, (-2.0 / 3.0 * viscosity) * trace(grad_v));
}

}  // namespace softwet
