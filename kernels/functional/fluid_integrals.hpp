// Integrals over the fluid: mass, momentum, energies, and the rates at which energy is dissipated.
#pragma once

#include "kernels/fluid/gravity.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"

namespace softwet {

/// Fluid and mesh at a point.
template <class N, int D>
struct FluidState : FluidTrial<N, D> {
  N volume_ratio;  ///< J of the mesh map

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION FluidState read(const Reader& at) {
    return {FluidTrial<N, D>::read(at), at.volume_ratio()};
  }
};

/// Integrands over the current fluid domain, in this order:
///   mass rho, kinetic rho |v|^2/2, bulk W(rho), gradient g^2 |grad rho|^2/2,
///   viscous dissipation tau : grad v, stabilisation eps |grad mu - f|^2 (f: gravity), folded -1 where J < 0, volume 1,
///   momentum rho v_i (3)
/// The integral of `folded` is the volume of the mesh that is turned inside out: it must be 0.
/// Tested: tests/unit/functional/test_integrals.cpp
struct FluidIntegrals {
  static constexpr Where where = Where::fluid;

  NavierStokesKorteweg model;
  Gravity gravity = {};

  enum { mass, kinetic, bulk, gradient, viscous, stabilisation, folded, volume, momentum };
  static constexpr int count = 11;

  template <class N, int D>
  using Trial = FluidState<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const FluidState<N, D>& t) const {
    const double lambda = model.capillarity * model.capillarity;
    Vector<N, count> r;
    r[mass] = t.density;
    r[kinetic] = 0.5 * t.density * dot(t.velocity, t.velocity);
    r[bulk] = model.gas.energy(t.density);
    r[gradient] = 0.5 * lambda * dot(t.density_gradient, t.density_gradient);
    r[viscous] = contract(newtonian_stress(model.viscosity, t.velocity_gradient), t.velocity_gradient);
    Vector<N, D> drive;
    for (int i = 0; i < D; ++i) drive[i] = t.chemical_potential_gradient[i] - gravity.force[i];
    r[stabilisation] = model.stabilisation * t.density * t.density * dot(drive, drive);
    r[folded] = select(t.volume_ratio < 0.0, N(-1.0), N(0.0));
    r[volume] = N(1.0);
    for (int i = 0; i < 3; ++i) r[momentum + i] = i < D ? t.density * t.velocity[i < D ? i : 0] : N(0.0);
    return r;
  }
};

/// Integrands over the wall Gamma: its area, the area wetted by liquid, and the wall energy f_w(rho).
/// Tested: tests/unit/functional/test_integrals.cpp
struct WallIntegrals {
  static constexpr Where where = Where::wall;

  EnergyWall law;

  enum { area, wetted, energy };
  static constexpr int count = 3;

  template <class N, int D>
  using Trial = DensityTrial<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const DensityTrial<N, D>& t) const {
    Vector<N, count> r;
    r[area] = N(1.0);
    const double middle = 0.5 * (law.state.density_vapour + law.state.density_liquid);
    r[wetted] = select(t.density < middle, N(0.0), N(1.0));
    r[energy] = wall_energy(t.density);
    return r;
  }

  /// f_w(rho) = -cos(alpha) g int_{rho_v}^{rho} sqrt(2 D); scale a b^2 L0. sqrt(2 D) has a kink at rho_l, which the
  /// liquid of a droplet lies beyond (Laplace): the integral is split there.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N wall_energy(const N& rho) const {
    const N vapour = N(law.state.density_vapour), liquid = N(law.state.density_liquid);
    const N middle = select(rho < law.state.density_liquid, rho, liquid);
    return -1.0 * (integral(vapour, middle) + integral(middle, rho));
  }

 private:
  /// Integral of the force by 8 panels of 8-point Gauss-Legendre in t, rho = from + (to - from) t^2: the points gather
  /// at the vapour's end, where W'' is largest.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N integral(const N& from, const N& to) const {
    // Abscissae and weights on [-1, 1], positive half.
    const double x[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    const double w[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const int parts = 8;
    const N span = to - from;
    N sum = N(0.0);
    for (int p = 0; p < parts; ++p)
      for (int i = 0; i < 8; ++i) {
        const double t = (p + 0.5 * (1.0 + (i < 4 ? x[i] : -x[i - 4]))) / parts;
        sum = sum + (w[i % 4] * t) * law.force(from + (t * t) * span);
      }
    return (1.0 / parts) * (span * sum);
  }
};

}  // namespace softwet
