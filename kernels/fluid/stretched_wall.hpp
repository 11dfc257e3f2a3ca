// Walls whose energy depends on how much they are stretched.
#pragma once

#include "kernels/fluid/painted_wall.hpp"

namespace softwet {

/// What a law of the wall sees, and the deformed over the undeformed area a; in the coordinates (r, z) it has the
/// stretch r / R.
template <class Inner, class N>
struct StretchedTrial {
  Inner wall;
  N area_ratio;

  static constexpr int slot_count = Inner::slot_count;
  static constexpr Slot slot(int s) { return Inner::slot(s); }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION StretchedTrial read(const Reader& at) {
    return {Inner::read(at), at.area_ratio()};
  }

  /// This law with the given field s c a^(-beta) in the place of c.
  KOKKOS_FORCEINLINE_FUNCTION Inner with(double beta, double share = 1) const {
    Inner inner = wall;
    inner.given = share * real_power(area_ratio, -beta) * inner.given;
    return inner;
  }
};

/// A law of the wall that is linear in the cosine c of the contact angle, with s a^(-beta) c in its place. The wall
/// energy
///   int_{Gamma_0} a^(1 - beta) c f(rho) dA_0 = int_Gamma a^(-beta) c f(rho) dA,   f for the cosine 1,
/// has the derivative a^(-beta) c f'(rho) by the density, which is PaintedWall<EnergyWall> with s = 1, and the tension
/// (1 - beta) a^(-beta) c f(rho), which is WallTension with s = 1 - beta. So the effective contact angle has the cosine
/// a^(-beta) c. Where a counts from an area before a prestretch, c has the factor a_0^(-beta).
/// Tested: tests/unit/fluid/test_stretched_wall.cpp, tests/unit/scene/test_stretched_wall.cpp
template <class Law>
struct StretchedWall {
  static constexpr Where where = Where::wall;

  Law law;
  double exponent = 0;  ///< beta
  double share = 1;     ///< s

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = StretchedTrial<typename Law::template Trial<N, D, M>, N>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = typename Law::template Test<N, D, M>;

  template <class Inner, class N>
  KOKKOS_FORCEINLINE_FUNCTION auto residual(const StretchedTrial<Inner, N>& t) const {
    return law.residual(t.with(exponent, share));
  }
};

}  // namespace softwet
