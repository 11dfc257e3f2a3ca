// Integrals over the fluid: mass, momentum, energies, and the rates at which energy is dissipated.
#pragma once

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/functional/columns.hpp"
#include "kernels/functional/liquid_volume.hpp"

namespace softwet {

/// Integrands over the current fluid domain, in this order:
///   mass rho, kinetic rho |v|^2/2, bulk W(rho), gradient g^2 |grad rho|^2/2,
///   viscous dissipation tau : grad v, stabilisation eps |grad mu - f|^2, momentum rho v_i (3), share of liquid
///     (LiquidVolume)
/// Tested: tests/unit/functional/test_integrals.cpp
struct FluidIntegrals {
  static constexpr Where where = Where::fluid;

  NavierStokesKorteweg model;
  LiquidVolume phases = {};

  enum { mass, kinetic, bulk, gradient, viscous, stabilisation, momentum, liquid = momentum + 3 };
  static constexpr int count = 10;
  static constexpr const char* column(int integral) {
    switch (integral) {
      case mass:
        return "mass";
      case kinetic:
        return "energy_kinetic";
      case bulk:
        return "energy_free_bulk";
      case gradient:
        return "energy_free_gradient";
      case viscous:
        return "dissipation_viscous";
      case stabilisation:
        return "dissipation_stabilisation";
      case liquid:
        return "liquid_volume";
      default:
        return momentum_columns[integral - momentum];
    }
  }

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = FluidTrial<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const FluidTrial<N, D, M>& t) const {
    Vector<N, count> r;
    r[mass] = t.density;
    r[kinetic] = 0.5 * t.density * dot(t.velocity, t.velocity);
    r[bulk] = model.gas.energy(t.density);
    r[gradient] = gradient_energy(model.capillarity, t.density_gradient);
    r[viscous] = contract(newtonian_stress(model.viscosity, t.velocity_gradient), t.velocity_gradient);
    const Vector<N, D> driven = drive(t.chemical_potential_gradient, model.force);
    r[stabilisation] = model.stabilisation * t.density * t.density * dot(driven, driven);
    for (int i = 0; i < 3; ++i) r[momentum + i] = i < D ? t.density * t.velocity[i < D ? i : 0] : N(0.0);
    r[liquid] = phases.of(t.density);
    return r;
  }
};

/// Density and mesh at a point.
template <class N, int D>
struct FilledMesh : DensityValueTrial<N, D> {
  N volume_ratio;  ///< J of the mesh map

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION FilledMesh read(const Reader& at) {
    return {DensityValueTrial<N, D>::read(at), at.volume_ratio()};
  }
};

/// Integrands over the current fluid domain that each step asks for: mass rho, volume 1, folded -1 where J < 0.
/// The integral of `folded` is the volume of the mesh that is turned inside out: it must be 0.
/// Tested: tests/unit/functional/test_integrals.cpp
struct FluidContents {
  static constexpr Where where = Where::fluid;

  enum { mass, volume, folded };
  static constexpr int count = 3;

  template <class N, int D, class...>
  using Trial = FilledMesh<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const FilledMesh<N, D>& t) const {
    return {{t.density, N(1.0), select(t.volume_ratio < 0.0, N(-1.0), N(0.0))}};
  }
};

}  // namespace softwet
