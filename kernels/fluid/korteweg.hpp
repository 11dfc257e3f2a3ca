// Pressure and capillary stress of Korteweg type.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// g^2 |grad rho|^2 / 2: the free energy of a gradient of the density, scale a b^2.
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION N gradient_energy(double capillarity, const Vector<N, D>& density_gradient) {
  return (0.5 * (capillarity * capillarity)) * dot(density_gradient, density_gradient);
}

/// Reversible stress in potential form
///   Sigma = -p I + varsigma = (W - rho mu + g^2 |grad rho|^2 / 2) I - g^2 grad rho (x) grad rho
/// with mu = W' - g^2 Lap rho; its divergence is -rho grad mu.        symmetric, scale a b^2; M: its kind
/// @param capillarity  g = gamma_hat
/// @param energy       W(rho), scale a b^2
/// Source: Bueno et al. 2017, eqs. (5), (6), rewritten with mu.   Tested: tests/unit/fluid/test_korteweg.cpp
template <class N, int D, class M = Matrix<N, D>>
KOKKOS_FORCEINLINE_FUNCTION M reversible_stress(double capillarity, const N& energy, const N& density,
                                                const Vector<N, D>& density_gradient, const N& potential) {
  const double lambda = capillarity * capillarity;
  const N isotropic = energy - density * potential + gradient_energy(capillarity, density_gradient);
  return add_diagonal(embedded<M>((-lambda) * outer(density_gradient, density_gradient)), isotropic);
}

}  // namespace softwet
