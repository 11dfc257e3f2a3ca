// Walls whose contact angle varies along them, and the tension that the fluid gives a wall.
#pragma once

#include "kernels/fluid/wall_energy.hpp"
#include "kernels/point/given_fields.hpp"

namespace softwet {

/// A law of the contact angle, linear in the cosine, where the cosine varies: the paint sticks to the material points
/// of the wall. Law has the cosine 1; the given field is the cosine at the position.
/// Tested: tests/unit/fluid/test_stretched_wall.cpp, tests/unit/scene/test_energy.cpp
template <class Law>
struct PaintedWall {
  static constexpr Where where = Where::wall;

  Law law;

  template <class N, int D, class...>
  using Trial = WithGiven<DensityTrial<N, D>, N>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const WithGiven<DensityTrial<N, D>, N>& t) const {
    return {t.given * law.residual(t.trial).potential};
  }
};

/// Density at a point of the wall, its normal, and the cosine of the contact angle. M is the kind of the tension.
template <class N, int D, class M = Matrix<N, D>>
struct WallTensionTrial {
  N density;
  N given;              ///< the cosine
  Vector<N, D> normal;  ///< n, along the last axis

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::given}, true, false}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WallTensionTrial read(const Reader& at) {
    return {at.value(0), at.value(1), at.normal()};
  }
};

/// <cos(alpha) f(rho) P_Gamma : grad w>_Gamma,   P_Gamma = I - n n: the tension that a wall has because the fluid wets
/// it. With the energy f of the cosine 1 this is the derivative of the wall energy f_w by the position of the wall, so
/// that f_w acts on the wall.
/// Tested: tests/unit/fluid/test_stretched_wall.cpp, tests/unit/scene/test_energy.cpp
struct WallTension {
  static constexpr Where where = Where::wall;

  WallEnergy wall;  ///< of the cosine 1

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = WallTensionTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const WallTensionTrial<N, D, M>& t) const {
    const N tension = t.given * wall.value(t.density);
    M flux;
    if constexpr (is_axial_matrix<M>) flux.hoop = tension;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) flux(i, j) = tension * ((i == j ? 1.0 : 0.0) - t.normal[i] * t.normal[j]);
    }
    return MomentumTest<N, D, M>::of_flux(flux);
  }
};

}  // namespace softwet
