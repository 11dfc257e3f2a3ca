// The energy of the wall: uniform, painted and stretched.
#pragma once

#include "kernels/fluid/stretched_wall.hpp"

namespace softwet {

/// Integrand over the wall Gamma: its energy f_w(rho).
/// Tested: tests/unit/scene/test_energy.cpp
struct WallIntegrals {
  static constexpr Where where = Where::wall;

  WallEnergy wall;

  static constexpr int count = 1;
  static constexpr const char* column(int) { return "energy_wall"; }
  static constexpr const char* rate_column = "wall_stretch";  ///< of its rate by the motion of the wall

  template <class N, int D, class...>
  using Trial = DensityValueTrial<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const DensityValueTrial<N, D>& t) const {
    return {{wall.value(t.density)}};
  }
};

/// WallIntegrals with a given field for the cosine of the contact angle: cos(alpha) f(rho), where f has the cosine 1.
struct PaintedWallIntegrals : WallIntegrals {
  template <class N, int D, class...>
  using Trial = WithGiven<DensityValueTrial<N, D>, N>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const WithGiven<DensityValueTrial<N, D>, N>& t) const {
    return t.given * WallIntegrals::value(t.trial);
  }
};

/// PaintedWallIntegrals of a stretched wall: a^(-beta) cos(alpha) f(rho).
/// Tested: tests/unit/fluid/test_stretched_wall.cpp
struct StretchedWallIntegrals : PaintedWallIntegrals {
  double exponent = 0;  ///< beta

  template <class N, int D, class...>
  using Trial = StretchedTrial<PaintedWallIntegrals::Trial<N, D>, N>;

  template <class Inner, class N>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const StretchedTrial<Inner, N>& t) const {
    return PaintedWallIntegrals::value(t.with(exponent));
  }
};

}  // namespace softwet
