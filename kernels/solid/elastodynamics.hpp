// Momentum balance of the solid in its reference configuration: (w, rho_0 v_t) + (Grad w, P).
#pragma once

#include "kernels/point/solid_fields.hpp"

namespace softwet {

/// Material: `first_piola(Grad u)`, `energy(Grad u)`.
/// Source: Bueno et al. 2017, eq. (1).   Tested: tests/unit/solid/test_elastodynamics.cpp
template <class Material>
struct Elastodynamics {
  static constexpr Where where = Where::solid;
  static constexpr const char* energy_column = "energy_elastic";

  Material material;
  double density = 0;  ///< rho_0^s / b

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using EnergyTrial = SolidStrain<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidTrial<N, D, M>& t) const {
    return {density * t.acceleration, material.first_piola(t.displacement_gradient)};
  }
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidStrain<N, D, M>& t) const {
    return material.energy(t.displacement_gradient);
  }
};

}  // namespace softwet
