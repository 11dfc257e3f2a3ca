// What the balances of mass and momentum of the fluid are made of. Implicit schemes evaluate them at once
// (navier_stokes_korteweg.hpp), explicit schemes part by part (explicit_terms.hpp). Stresses and the potential have
// their own files.
// Source: Bueno et al. 2017, eq. (7).   Tested: tests/unit/fluid/test_navier_stokes_korteweg.cpp
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// rho (v - vh): mass that passes through the mesh, scale b sqrt(ab).
/// @param slip  v - vh, the velocity relative to the mesh
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mass_flux(const N& density, const Vector<N, D>& slip) {
  return density * slip;
}

/// (v - vh).grad v: rate of the velocity by what passes through the mesh, scale a b/L0.
template <class M, class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> convection(const M& velocity_gradient, const Vector<N, D>& slip) {
  return product(velocity_gradient, slip);
}

/// max(rho, floor): the density in the inertia, scale b.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N inertial_density(const N& density, double floor) {
  return select(density < floor, N(floor), density);
}

/// grad mu - f: what drives the fluid, for each mass; 0 at rest. Scale a b/L0.
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> drive(const Vector<N, D>& potential_gradient, const double (&force)[3]) {
  Vector<N, D> r;
  for (int i = 0; i < D; ++i) r[i] = potential_gradient[i] - force[i];
  return r;
}

/// eps = (C h^2 / m) rho^2: mass flux of the stabilisation over what drives it, scale L0 sqrt(b/a).
/// @param factor  C h^2 / m
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N stabilising_mobility(double factor, const N& density) {
  return factor * (density * density);
}

}  // namespace softwet
