// The equations of the fluid in the parts that explicit schemes evaluate one by one (see navier_stokes_korteweg.hpp).
#pragma once

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/point/explicit_fields.hpp"

namespace softwet {

/// Flux of mass, - (grad q, rho (v - vh)).
struct MassFlux {
  static constexpr Where where = Where::fluid;

  template <class N, int D, class...>
  using Trial = MassFluxTrial<N, D>;
  template <class N, int D, class...>
  using Test = MassFluxTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION MassFluxTest<N, D> residual(const MassFluxTrial<N, D>& t) const {
    return {-1.0 * mass_flux(t.density, t.velocity - t.mesh_velocity)};
  }
};

/// Force of pressure, capillarity and gravity, (w, rho (grad mu - f)), and the flux of the stabilisation,
/// (grad q, eps (grad mu - f)).
struct PressureForce {
  static constexpr Where where = Where::fluid;

  NavierStokesKorteweg fluid;

  template <class N, int D, class...>
  using Trial = PressureTrial<N, D>;
  template <class N, int D, class...>
  using Test = PressureTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION PressureTest<N, D> residual(const PressureTrial<N, D>& t) const {
    const Vector<N, D> driven = drive(t.chemical_potential_gradient, fluid.force);
    return {t.density * driven, stabilising_mobility(fluid.stabilisation, t.density) * driven};
  }
};

/// Convection and viscosity, (w, rho (v - vh).grad v) + (grad w, tau).
struct ConvectionViscosity {
  static constexpr Where where = Where::fluid;

  double viscosity = 0;  ///< mu_hat, or 0 where it is treated apart
  double floor = 0;      ///< smallest density in the inertia, as in NavierStokesKorteweg

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = ConvectionTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const ConvectionTrial<N, D, M>& t) const {
    const Vector<N, D> slip = t.velocity - t.mesh_velocity;
    return {inertial_density(t.density, floor) * convection(t.velocity_gradient, slip),
            newtonian_stress(viscosity, t.velocity_gradient)};
  }
};

}  // namespace softwet
