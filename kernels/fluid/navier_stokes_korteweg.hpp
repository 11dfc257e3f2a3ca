// Isothermal Navier-Stokes-Korteweg equations in potential form, on a moving mesh (Bueno et al. 2017, eq. 7).
//
//   mass       d/dt (q, rho) - (grad q, rho (v - vh)) + (grad q, eps (grad mu - f)) = 0      q moves with the mesh
//   potential  (q, mu - W'(rho)) - (grad q, g^2 grad rho) = 0
//   momentum   (w, rho [v_t + (v - vh).grad v]) + (grad w, tau) + (w, rho (grad mu - f)) = 0
//
// f is a uniform force per unit mass, such as gravity. At rest grad mu = f, so that the stabilisation moves no mass
// then.
//
// `NavierStokesKorteweg` holds all of this but the moment (q, rho), which is `DensityMoment`.
// Next to the wall the momentum force (w, rho grad mu) is replaced by its variational form (grad w, Sigma) for the
// wall's own basis functions: see `CapillaryTraction`.
#pragma once

#include "kernels/fluid/balances.hpp"
#include "kernels/fluid/contact_angle.hpp"
#include "kernels/fluid/korteweg.hpp"
#include "kernels/fluid/newtonian.hpp"

namespace softwet {

/// What the density contributes to the potential equation, - (q, W'(rho)) - (grad q, g^2 grad rho). Explicit schemes
/// find mu from it.
struct VariationalDerivative {
  static constexpr Where where = Where::fluid;

  VanDerWaals gas;
  double capillarity = 0;  ///< g = gamma_hat, eq. (8)

  template <class N, int D, class...>
  using Trial = DensityTrial<N, D>;
  template <class N, int D, class...>
  using Test = PotentialTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION PotentialTest<N, D> residual(const DensityTrial<N, D>& t) const {
    return {-1.0 * gas.derivative(t.density), (-capillarity * capillarity) * t.density_gradient};
  }
};

/// The moment of the density, (q, rho) on the moved mesh: what the balance of mass keeps.
struct DensityMoment {
  static constexpr Where where = Where::fluid;

  template <class N, int D, class...>
  using Trial = DensityValueTrial<N, D>;
  template <class N, int D, class...>
  using Test = MassTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION MassTest<N, D> residual(const DensityValueTrial<N, D>& t) const {
    return {t.density};
  }
};

struct NavierStokesKorteweg {
  static constexpr Where where = Where::fluid;

  VanDerWaals gas;
  double viscosity = 0;         ///< m = mu_hat, eq. (9)
  double capillarity = 0;       ///< g = gamma_hat, eq. (8)
  double stabilisation = 0;     ///< C h^2 / m: eps = (C h^2 / m) rho^2, checkerboard control
  double inertia_floor = 0;     ///< smallest density in the inertia term
  double force[3] = {0, 0, 0};  ///< f, scale a b/L0

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = FluidTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = FluidTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION FluidTest<N, D, M> residual(const FluidTrial<N, D, M>& t) const {
    const N& rho = t.density;
    const Vector<N, D> slip = t.velocity - t.mesh_velocity;
    const N inertia = inertial_density(rho, inertia_floor), eps = stabilising_mobility(stabilisation, rho);
    const Vector<N, D> driven = drive(t.chemical_potential_gradient, force);

    FluidTest<N, D, M> r;
    r.momentum = inertia * (t.acceleration + convection(t.velocity_gradient, slip)) + rho * driven;
    r.momentum_flux = newtonian_stress(viscosity, t.velocity_gradient);
    r.mass_flux = eps * driven - mass_flux(rho, slip);
    const PotentialTest<N, D> w =
        VariationalDerivative{gas, capillarity}.residual(DensityTrial<N, D>{rho, t.density_gradient});
    r.potential = t.chemical_potential + w.potential;
    r.potential_flux = w.potential_flux;
    return r;
  }
};

/// (grad w, Sigma) - (w, rho grad mu) for the wall's basis functions w: together with the volume force this is the
/// variational traction of the fluid on the solid; it carries the full capillary line force and the Laplace pressure.
struct CapillaryTraction {
  static constexpr Where where = Where::beside_wall;

  VanDerWaals gas;
  double capillarity = 0;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = TractionTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const TractionTrial<N, D, M>& t) const {
    MomentumTest<N, D, M> r;
    r.momentum = (-1.0 * t.density) * t.chemical_potential_gradient;
    r.momentum_flux = reversible_stress<N, D, M>(capillarity, gas.energy(t.density), t.density, t.density_gradient,
                                                 t.chemical_potential);
    return r;
  }
};

}  // namespace softwet
