// Walls whose contact angle varies along them, and the tension that the fluid gives a wall.
#pragma once

#include "kernels/fluid/wall_energy.hpp"

namespace softwet {

/// Density and its gradient at a point of the wall, with the cosine of the contact angle there.
template <class N, int D>
struct PaintedTrial {
  DensityTrial<N, D> fluid;
  N cosine;

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return s == 0 ? DensityTrial<N, D>::slot(0) : Slot{{Field::given}, true, false}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION PaintedTrial read(const Reader& at) {
    return {DensityTrial<N, D>::read(at), at.value(1)};
  }
};

/// A law of the contact angle, linear in the cosine, where the cosine varies: the paint sticks to the material points of the wall.
/// Law has the cosine 1.   Tested: tests/unit/fluid/test_painted_wall.cpp
template <class Law>
struct PaintedWall {
  static constexpr Where where = Where::wall;

  Law law;

  template <class N, int D, class...>
  using Trial = PaintedTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const PaintedTrial<N, D>& t) const {
    return {t.cosine * law.residual(t.fluid).potential};
  }
};

/// Integrand over the wall: its energy cos(alpha) f(rho), f that of the cosine 1.
struct PaintedWallIntegrals {
  static constexpr Where where = Where::wall;

  WallEnergy wall;

  static constexpr int count = 1;
  static constexpr const char* column(int) { return "energy_wall"; }
  static constexpr const char* rate_column = "wall_stretch";  ///< of its rate by the motion of the wall

  template <class N, int D, class...>
  using Trial = PaintedTrial<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const PaintedTrial<N, D>& t) const {
    return {{t.cosine * wall.value(t.fluid.density)}};
  }
};

/// Density at a point of the wall, its normal, and the cosine of the contact angle. M is the kind of the tension.
template <class N, int D, class M = Matrix<N, D>>
struct WallTensionTrial {
  N density, cosine;
  Vector<N, D> normal;  ///< n, along the last axis

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::given}, true, false}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WallTensionTrial read(const Reader& at) {
    return {at.value(0), at.value(1), at.normal()};
  }
};

/// <cos(alpha) f(rho) P_Gamma : grad w>_Gamma,   P_Gamma = I - n n: the tension that a wall has because the fluid wets it. With the
/// energy f of the cosine 1 this is the derivative of the wall energy f_w by the place of the wall, so that f_w acts on the wall.
/// Tested: tests/unit/fluid/test_painted_wall.cpp, tests/unit/scene/test_energy.cpp
struct WallTension {
  static constexpr Where where = Where::wall;

  WallEnergy wall;  ///< of the cosine 1

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = WallTensionTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const WallTensionTrial<N, D, M>& t) const {
    const N tension = t.cosine * wall.value(t.density);
    MomentumTest<N, D, M> r;
    if constexpr (is_axial_matrix<M>) r.momentum_flux.hoop = tension;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      r.momentum[i] = N(0.0);
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) r.momentum_flux(i, j) = tension * ((i == j ? 1.0 : 0.0) - t.normal[i] * t.normal[j]);
    }
    return r;
  }
};

}  // namespace softwet
