// What a contact line loses as it moves along the wall: line friction, and the hysteresis of the contact angle.
#pragma once

#include "kernels/fluid/contact_angle.hpp"

namespace softwet {

/// Density at a point of the wall, and its rate at the material point of the wall.
template <class N, int D>
struct WettingTrial {
  N density;
  N rate;  ///< r', scale b sqrt(ab)/L0

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::density_rate}, true, false}; }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WettingTrial read(const Reader& at) {
    return {at.value(0), at.value(1)};
  }
};

/// -<q, B r' + k g sqrt(2 D(rho)) h(r'/r0)>_Gamma,   h(s) = s / sqrt(1 + s^2), added to the law "energy" of the contact
/// angle. It dissipates B r'^2 + k g sqrt(2 D) r' h >= 0 for each area of the wall. A line of the profile g d rho/ds =
/// -sqrt(2 D) that moves with the speed U has r' = U sin(alpha) sqrt(2 D)/g. So B = mu_f g^2 / (sigma sin(alpha)) is
/// the line friction mu_f, with sigma (cos(alpha) - cos(alpha_dyn)) = mu_f U, and k is half of cos(receding) -
/// cos(advancing).
/// Source: Yue 2020, J. Fluid Mech. 899, A15, for the idea.   Tested: tests/unit/fluid/test_line_friction.cpp
struct LineFriction {
  static constexpr Where where = Where::wall;
  static constexpr const char* dissipation_column = "dissipation_wall";

  double friction = 0;   ///< B
  double rest_rate = 1;  ///< r0, the rate below which a line counts as at rest
  EnergyWall barrier;    ///< k g sqrt(2 D): the force of the law with k in the place of the cosine

  template <class N, int D, class...>
  using Trial = WettingTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const WettingTrial<N, D>& t) const {
    return {-resistance(t.density, t.rate)};
  }

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N dissipation(const WettingTrial<N, D>& t) const {
    return t.rate * resistance(t.density, t.rate);
  }

 private:
  /// B r' + k g sqrt(2 D) h(r'/r0), scale a b L0.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N resistance(const N& density, const N& rate) const {
    const N s = (1 / rest_rate) * rate;
    return friction * rate + barrier.force(density) * (s / square_root(1.0 + s * s));
  }
};

/// What a point of the wall shows of a line that Newton's method has not balanced yet.
template <class N, int D>
struct UnbalancedTrial {
  WettingTrial<N, D> wetting;
  N unbalanced;  ///< R, the residual of the equation of the potential for each area of the wall

  static constexpr int slot_count = 3;
  static constexpr Slot slot(int s) {
    return s < 2 ? WettingTrial<N, D>::slot(s) : Slot{{Field::operand, D + 1}, true, false};
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION UnbalancedTrial read(const Reader& at) {
    return {WettingTrial<N, D>::read(at), at.value(2)};
  }
};

/// -<q, e r'>_Gamma, linear in r': what Newton's method adds to the Jacobian of LineFriction. With K = k g sqrt(2 D)
/// the wall has the equation R = F - K h(s), whose slope by s is flat where a line moves: from there a step leaps
/// across the bend of h, and back. The equation F sqrt(1 + s^2) = K s is the same and has no such bend. Its slope over
/// sqrt(1 + s^2) is K - F h, with F = R + K h between -K and K; where that is more than K h' it is taken: e = max(0, (K
/// - F h) / sqrt(1 + s^2) - K h') / r0. It vanishes with R.
/// Source: Chan, Golub, Mulet 1999, SIAM J. Sci. Comput. 20, 1964, for the regularised norm, whose derivative is h.
/// Tested: tests/unit/fluid/test_line_friction.cpp
struct LineFrictionBend {
  static constexpr Where where = Where::wall;

  LineFriction law;

  template <class N, int D, class...>
  using Trial = UnbalancedTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const UnbalancedTrial<N, D>& t) const {
    if constexpr (is_dual<N>) {
      using S = typename Plain<N>::type;
      const S e = slope(t.wetting.density.value, t.wetting.rate.value, t.unbalanced.value);
      return {-(N{e, S(0.0)} * t.wetting.rate)};
    } else {
      return {-(slope(t.wetting.density, t.wetting.rate, t.unbalanced) * t.wetting.rate)};
    }
  }

 private:
  /// e
  template <class S>
  KOKKOS_FORCEINLINE_FUNCTION S slope(const S& density, const S& rate, const S& unbalanced) const {
    const S s = (1 / law.rest_rate) * rate, inverse = 1.0 / square_root(1.0 + s * s), h = s * inverse;
    const S most = law.barrier.force(density), force = unbalanced + most * h;
    const S above = select(force + most < 0.0, S(-most), force), held = select(above - most < 0.0, above, most);
    const S more = (most - held * h) * inverse - most * (inverse * inverse * inverse);
    return (1 / law.rest_rate) * select(more < 0.0, S(0.0), more);
  }
};

}  // namespace softwet
