// Bundles of the terms of explicit schemes: each reads and writes what it needs and no more.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// What the flux of mass is made of.
template <class N, int D>
struct MassFluxTrial {
  Vector<N, D> velocity, mesh_velocity;
  N density;

  static constexpr int slot_count = D + 1;
  static constexpr Slot slot(int s) {
    if (s < D) return {{Field::velocity, s}, true, false};
    return {{Field::density}, true, false};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION MassFluxTrial read(const Reader& at) {
    MassFluxTrial t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) t.velocity[i] = at.value(i);
    t.density = at.value(D);
    t.mesh_velocity = at.mesh_velocity();
    return t;
  }
};

/// Integrand against grad q of mass.
template <class N, int D>
struct MassFluxTest {
  Vector<N, D> mass_flux;

  static constexpr int channel_count = 1;
  static constexpr bool has_flux = true;
  static constexpr bool value_of(int) { return false; }
  static constexpr Component channel(int) { return {Field::density}; }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, N(0.0), mass_flux);
  }
};

/// Density and gradient of the chemical potential.
template <class N, int D>
struct PressureTrial {
  N density;
  Vector<N, D> chemical_potential_gradient;

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::potential}, s == 0, s == 1}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION PressureTrial read(const Reader& at) {
    return {at.value(0), at.gradient(1)};
  }
};

/// Integrand against w of momentum and grad q of mass.
template <class N, int D>
struct PressureTest {
  Vector<N, D> momentum, mass_flux;

  static constexpr int channel_count = D + 1;
  static constexpr bool has_flux = true;
  static constexpr bool flux_of(int c) { return c == D; }
  static constexpr bool value_of(int c) { return c < D; }
  static constexpr Component channel(int c) {
    return c < D ? Component{Field::velocity, c} : Component{Field::density};
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    Vector<N, D> none;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) none[i] = N(0.0);
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) to.add(i, momentum[i], none);
    to.add(D, N(0.0), mass_flux);
  }
};

/// Velocity with its gradient, and density.
template <class N, int D, class M = Matrix<N, D>>
struct ConvectionTrial {
  Vector<N, D> velocity, mesh_velocity;
  M velocity_gradient;
  N density;

  static constexpr int slot_count = D + 1;
  static constexpr Slot slot(int s) {
    if (s < D) return {{Field::velocity, s}, true, true};
    return {{Field::density}, true, false};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION ConvectionTrial read(const Reader& at) {
    ConvectionTrial t;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) t.velocity[i] = at.value(i);
    t.velocity_gradient = gradient_of<M, N, D>(at, 0);
    t.density = at.value(D);
    t.mesh_velocity = at.mesh_velocity();
    return t;
  }
};

}  // namespace softwet
