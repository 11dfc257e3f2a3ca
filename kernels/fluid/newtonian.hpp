// Newtonian viscous stress.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// tau = m (grad v + grad v^T) - (2/3) m div v I        of the kind of grad v, symmetric, scale a b^2
/// @param viscosity  m = mu_hat
/// @param grad_v     (grad v)_ij = dv_i/dx_j, scale sqrt(ab)/L0. In 2D dv_z = 0.
/// Source: Bueno et al. 2017, eq. (4) with the Stokes hypothesis.   Tested: tests/unit/fluid/test_newtonian.cpp
template <class M>
KOKKOS_FORCEINLINE_FUNCTION M newtonian_stress(double viscosity, const M& grad_v) {
  return add_diagonal(viscosity * (grad_v + transpose(grad_v)), (-2.0 / 3.0 * viscosity) * trace(grad_v));
}

}  // namespace softwet
