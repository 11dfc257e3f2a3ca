// Bundles of the terms of the fluid and of the wall.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// Fluid at a point. Unknowns: velocity (D), density, chemical potential; gradients are with respect to x.
template <class N, int D, class M = Matrix<N, D>>
struct FluidTrial {
  Vector<N, D> velocity;      ///< v, sqrt(ab)
  M velocity_gradient;        ///< (grad v)_ij = dv_i/dx_j
  Vector<N, D> acceleration;  ///< dv/dt at fixed mesh coordinate
  N density;                  ///< rho, b
  Vector<N, D> density_gradient;
  N chemical_potential;  ///< mu, a b
  Vector<N, D> chemical_potential_gradient;
  Vector<N, D> mesh_velocity;  ///< vh

  static constexpr int density_slot = 2 * D, potential_slot = 2 * D + 1, slot_count = 2 * D + 2;

  static constexpr Slot slot(int s) {
    if (s < D) return {{Field::velocity, s}, true, true};
    if (s < 2 * D) return {{Field::acceleration, s - D}, true, false};
    return {{s == density_slot ? Field::density : Field::potential}, true, true};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION FluidTrial read(const Reader& at) {
    FluidTrial t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      t.velocity[i] = at.value(i);
      t.acceleration[i] = at.value(D + i);
    }
    t.velocity_gradient = gradient_of<M, N, D>(at, 0);
    t.density = at.value(density_slot);
    t.density_gradient = at.gradient(density_slot);
    t.chemical_potential = at.value(potential_slot);
    t.chemical_potential_gradient = at.gradient(potential_slot);
    t.mesh_velocity = at.mesh_velocity();
    return t;
  }
};

/// Integrand against (w, grad w) of momentum, grad q of mass and (q, grad q) of the potential equation.
template <class N, int D, class M = Matrix<N, D>>
struct FluidTest {
  Vector<N, D> momentum;
  M momentum_flux;
  Vector<N, D> mass_flux;
  N potential;
  Vector<N, D> potential_flux;

  static constexpr int channel_count = D + 2;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int c) {
    if (c < D) return {Field::velocity, c};
    return {c == D ? Field::density : Field::potential};
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    write_momentum(to, momentum, momentum_flux);
    to.add(D, N(0.0), mass_flux);
    to.add(D + 1, potential, potential_flux);
  }
};

/// Density and its gradient at a point of the fluid or of the wall Gamma.
template <class N, int D>
struct DensityTrial {
  N density;
  Vector<N, D> density_gradient;

  static constexpr int slot_count = 1;
  static constexpr Slot slot(int) { return {{Field::density}, true, true}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION DensityTrial read(const Reader& at) {
    return {at.value(0), at.gradient(0)};
  }
};

/// Density alone at a point of the fluid.
template <class N, int D>
struct DensityValueTrial {
  N density;

  static constexpr int slot_count = 1;
  static constexpr Slot slot(int) { return {{Field::density}, true, false}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION DensityValueTrial read(const Reader& at) {
    return {at.value(0)};
  }
};

/// Density and chemical potential next to the wall. M is the kind of the stress that follows from them.
template <class N, int D, class M = Matrix<N, D>>
struct TractionTrial {
  N density;
  Vector<N, D> density_gradient;
  N chemical_potential;
  Vector<N, D> chemical_potential_gradient;

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::potential}, true, true}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION TractionTrial read(const Reader& at) {
    return {at.value(0), at.gradient(0), at.value(1), at.gradient(1)};
  }
};

template <class N, int D>
struct WallTest {
  N potential;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = false;
  static constexpr Component channel(int) { return {Field::potential}; }
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, potential);
  }
};

/// Integrand against (q, grad q) of the potential equation alone.
template <class N, int D>
struct PotentialTest {
  N potential;
  Vector<N, D> potential_flux;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int) { return {Field::potential}; }
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, potential, potential_flux);
  }
};

/// Integrand against q of the mass equation alone.
template <class N, int D>
struct MassTest {
  N mass;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = false;
  static constexpr Component channel(int) { return {Field::density}; }
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, mass);
  }
};

}  // namespace softwet
