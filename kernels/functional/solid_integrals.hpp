// Integrals over the solid: kinetic energy, momentum; and where it is turned inside out.
#pragma once

#include "kernels/functional/columns.hpp"
#include "kernels/point/vector_fields.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// Integrands over the reference domain: kinetic energy rho_0 |v|^2/2, momentum rho_0 v_i (3).
/// Tested: tests/unit/functional/test_integrals.cpp
struct SolidMotion {
  static constexpr Where where = Where::solid;

  double density = 0;  ///< rho_0^s / b

  enum { kinetic, momentum };
  static constexpr int count = 4;
  static constexpr const char* column(int integral) {
    return integral == kinetic ? "energy_kinetic" : momentum_columns[integral - momentum];
  }

  template <class N, int D, class...>
  using Trial = SolidVelocity<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const SolidVelocity<N, D>& t) const {
    Vector<N, count> r;
    r[kinetic] = (0.5 * density) * dot(t.vector, t.vector);
    for (int i = 0; i < 3; ++i) r[momentum + i] = i < D ? density * t.vector[i < D ? i : 0] : N(0.0);
    return r;
  }
};

/// 1 where det F <= 0, over the reference domain. The integral must be 0: there the material law has no meaning.
/// Tested: tests/unit/functional/test_integrals.cpp
struct InvertedSolid {
  static constexpr Where where = Where::solid;
  static constexpr int count = 1;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrain<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const SolidStrain<N, D, M>& t) const {
    return {{select(0.0 < volume_ratio(t.displacement_gradient), N(0.0), N(1.0))}};
  }
};

}  // namespace softwet
