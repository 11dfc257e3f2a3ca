// Integrals over the solid: kinetic and elastic energy, momentum, and what is turned inside out.
#pragma once

#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// Velocity and displacement gradient of the solid at a point, for energies.
template <class N, int D>
struct SolidState {
  Vector<N, D> velocity;
  Matrix<N, D> displacement_gradient;

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{{Field::velocity, s}, true, false} : Slot{{Field::displacement, s - D}, false, true};
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidState read(const Reader& at) {
    const SolidTrial<N, D> t = SolidTrial<N, D>::read(at);
    return {t.acceleration, t.displacement_gradient};
  }
};

/// Integrands over the reference domain: kinetic rho_0 |v|^2/2, elastic energy, inverted 1 where
/// det F <= 0, momentum rho_0 v_i (3). The integral of `inverted` must be 0: there the material law has no meaning.
/// Tested: tests/unit/functional/test_integrals.cpp
template <class Material>
struct SolidIntegrals {
  static constexpr Where where = Where::solid;

  Elastodynamics<Material> model;

  enum { kinetic, elastic, inverted, momentum };
  static constexpr int count = 6;

  template <class N, int D>
  using Trial = SolidState<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const SolidState<N, D>& t) const {
    Vector<N, count> r;
    r[kinetic] = (0.5 * model.density) * dot(t.velocity, t.velocity);
    r[elastic] = model.material.energy(t.displacement_gradient);
    r[inverted] = select(0.0 < volume_ratio(t.displacement_gradient), N(0.0), N(1.0));
    for (int i = 0; i < 3; ++i) r[momentum + i] = i < D ? model.density * t.velocity[i < D ? i : 0] : N(0.0);
    return r;
  }
};

}  // namespace softwet
