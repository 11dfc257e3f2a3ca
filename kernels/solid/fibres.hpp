// Fibres in the solid: a family with one direction, which resists stretch along it.
#pragma once

#include <cmath>

#include "kernels/point/solid_fields.hpp"
#include "kernels/solid/prestretch.hpp"

namespace softwet {

/// Energy k/2 (I_4 - 1)^2 for each undeformed volume, I_4 = |F a_0|^2, in addition to the energy of the material; P = 2
/// k (I_4 - 1) F a_0 (x) a_0. Along the fibres a small strain meets the further modulus 4 k.
/// Scale of k: a b^2.   Source: the standard reinforcing model of fibres.
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct Fibres {
  static constexpr Where where = Where::solid;
  static constexpr const char* energy_column = "energy_elastic";

  double stiffness = 0;                       ///< k
  Vector<double, 3> direction = {{1, 0, 0}};  ///< a_0, unit vector along the axes
  double finite = 1;  ///< 0 where strains are small: F = I in P, and I_4 - 1 = 2 a_0 . Grad u a_0
  double excess = 0;  ///< added to I_4 - 1: 1 - 1/l^2 of fibres that are stretched by l where u = 0

  /// These fibres in a solid that was stretched before. With F_0 a_0 = l e their energy for each stretched volume is
  ///   k/2 (l^2 |F e|^2 - 1)^2 / J_0 = (k l^4 / J_0)/2 (|F e|^2 - 1/l^2)^2
  Fibres after(const Prestretch& before) const {
    if (!before.acts) return *this;
    Fibres r = *this;
    double square = 0;
    for (int d = 0; d < 3; ++d) {
      r.direction[d] = before.stretch[d] * direction[d];
      square += r.direction[d] * r.direction[d];
    }
    r.direction = (1 / std::sqrt(square)) * r.direction;
    r.stiffness = stiffness * square * square / before.volume_ratio();
    r.excess = 1 - 1 / square;
    return r;
  }

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidStrain<N, D, M>& t) const {
    const Vector<N, D> moved = along<N, D>(t.displacement_gradient);
    const N tension = (2.0 * stiffness) * (stretch(moved) + excess);
    M flux;
    if constexpr (is_axial_matrix<M>) flux.hoop = N(0.0);
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      const N pull = tension * (finite * moved[i] + direction[i]);
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) flux(i, j) = direction[j] * pull;
    }
    return MomentumTest<N, D, M>::of_flux(flux);
  }

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidStrain<N, D, M>& t) const {
    const N more = stretch(along<N, D>(t.displacement_gradient));
    return (0.5 * stiffness) * (more * (more + 2.0 * excess));
  }

 private:
  /// Grad u a_0
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> along(const M& grad_u) const {
    Vector<N, D> r;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      r[i] = direction[0] * grad_u(i, 0);
      SOFTWET_UNROLL
      for (int j = 1; j < D; ++j) r[i] = r[i] + direction[j] * grad_u(i, j);
    }
    return r;
  }
  /// I_4 - 1, and that where u = 0 is 0
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N stretch(const Vector<N, D>& moved) const {
    N sum = finite * dot(moved, moved);
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) sum = sum + (2.0 * direction[i]) * moved[i];
    return sum;
  }
};

}  // namespace softwet
