// The linear operators on velocities that time schemes invert: masses of the fluid and the solid, and the viscosity.
#pragma once

#include "kernels/fluid/balances.hpp"
#include "kernels/fluid/newtonian.hpp"
#include "kernels/point/vector_fields.hpp"

namespace softwet {

/// Inertia and viscosity of the fluid acting on a velocity z: inertia (w, max(rho, floor) z) + (grad w, tau(z)). It is
/// symmetric and positive definite. Time schemes that treat viscosity implicitly invert it.
struct WeightedViscosity {
  static constexpr Where where = Where::fluid;

  double inertia = 1;    ///< 1: a mass; 0: the viscous force alone
  double viscosity = 0;  ///< mu_hat times the step of the scheme, or mu_hat for the viscous force
  double floor = 0;      ///< smallest density in the inertia, as in NavierStokesKorteweg

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = WeightedTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const WeightedTrial<N, D, M>& t) const {
    const N weight = inertia * inertial_density(t.density, floor);
    return {weight * t.vector, newtonian_stress(viscosity, t.gradient)};
  }
};

/// Mass matrix of the solid, (w, rho_0 z).
struct SolidMass {
  static constexpr Where where = Where::solid;

  double density = 0;  ///< rho_0^s / b

  template <class N, int D, class...>
  using Trial = VectorTrial<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const VectorTrial<N, D>& t) const {
    return {density * t.vector};
  }
};

}  // namespace softwet
