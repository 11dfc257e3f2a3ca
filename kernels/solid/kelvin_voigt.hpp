// Viscosity of the solid, parallel to its elasticity (Kelvin-Voigt).
#pragma once

#include "kernels/point/solid_fields.hpp"
#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// (Grad w, F S_v),   S_v = 2 eta (E' - tr E'/3 I) + zeta tr E' I,   E' = sym(F^T Grad v), the rate of the
/// Green-Lagrange strain. It dissipates S_v : E' >= 0 for each undeformed volume, and nothing in a rigid rotation. In
/// 2D E'_33 = 0. Scale of eta and zeta: L0 b sqrt(ab).   Tested: tests/unit/solid/test_solid_terms.cpp
struct KelvinVoigt {
  static constexpr Where where = Where::solid;
  static constexpr const char* dissipation_column = "dissipation_solid";

  double shear = 0;   ///< eta
  double bulk = 0;    ///< zeta
  double finite = 1;  ///< 0 where strains are small: F = I

  /// What bounds explicit steps.
  double rate() const { return 4.0 / 3 * shear + bulk; }

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrainRate<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidStrainRate<N, D, M>& t) const {
    const M s = stress(strain_rate(t));
    return MomentumTest<N, D, M>::of_flux(s + finite * product(t.displacement_gradient, s));
  }

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N dissipation(const SolidStrainRate<N, D, M>& t) const {
    const M rate = strain_rate(t);
    return contract(stress(rate), rate);
  }

 private:
  /// E'
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION M strain_rate(const SolidStrainRate<N, D, M>& t) const {
    return green_lagrange_rate(t.displacement_gradient, t.velocity_gradient, finite);
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M stress(const M& rate) const {
    return linear_stress({bulk - 2.0 / 3 * shear, shear}, rate);
  }
};

}  // namespace softwet
