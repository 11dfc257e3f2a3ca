// Integrals over the solid: kinetic and elastic energy, momentum; and what is turned inside out.
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

/// Integrands over the reference domain: kinetic rho_0 |v|^2/2, elastic energy, momentum rho_0 v_i (3).
/// Tested: tests/unit/functional/test_integrals.cpp
template <class Material>
struct SolidIntegrals {
  static constexpr Where where = Where::solid;

  Elastodynamics<Material> model;

  enum { kinetic, elastic, momentum };
  static constexpr int count = 5;

  template <class N, int D>
  using Trial = SolidState<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const SolidState<N, D>& t) const {
    Vector<N, count> r;
    r[kinetic] = (0.5 * model.density) * dot(t.velocity, t.velocity);
    r[elastic] = model.material.energy(t.displacement_gradient);
    for (int i = 0; i < 3; ++i) r[momentum + i] = i < D ? model.density * t.velocity[i < D ? i : 0] : N(0.0);
    return r;
  }
};

/// Displacement gradient of the solid at a point.
template <class N, int D>
struct SolidStrain {
  Matrix<N, D> displacement_gradient;

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return {{Field::displacement, s}, false, true}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidStrain read(const Reader& at) {
    SolidStrain t;
    for (int i = 0; i < D; ++i) {
      const Vector<N, D> g = at.gradient(i);
      for (int j = 0; j < D; ++j) t.displacement_gradient(i, j) = g[j];
    }
    return t;
  }
};

/// 1 where det F <= 0, over the reference domain. The integral must be 0: there the material law has no meaning.
/// Tested: tests/unit/functional/test_integrals.cpp
struct InvertedSolid {
  static constexpr Where where = Where::solid;
  static constexpr int count = 1;

  template <class N, int D>
  using Trial = SolidStrain<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const SolidStrain<N, D>& t) const {
    return {{select(0.0 < volume_ratio(t.displacement_gradient), N(0.0), N(1.0))}};
  }
};

}  // namespace softwet
