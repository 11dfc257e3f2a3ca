// Momentum balance of the solid in its reference configuration: (w, rho_0 v_t) + (Grad w, F S).
#pragma once

#include "kernels/point/fields.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {

/// Source: Bueno et al. 2017, eq. (1).   Tested: tests/unit/solid/test_elastodynamics.cpp
struct Elastodynamics {
  static constexpr Where where = Where::solid;

  SaintVenantKirchhoff material;
  double density = 0;  ///< rho_0^s / b

  template <class N, int D>
  using Trial = SolidTrial<N, D>;
  template <class N, int D>
  using Test = MomentumTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D> residual(const SolidTrial<N, D>& t) const {
    return {density * t.acceleration, material.first_piola(t.displacement_gradient)};
  }
};

}  // namespace softwet
