// Wetting of the wall Gamma: the natural boundary condition of the potential equation, in two laws.
#pragma once

#include "kernels/fluid/van_der_waals.hpp"
#include "kernels/point/fluid_fields.hpp"

namespace softwet {

/// Liquid and vapour at equal pressure and chemical potential.
struct Coexistence {
  double density_vapour = 0, density_liquid = 0;
  double pressure = 0;   ///< p_s
  double potential = 0;  ///< mu_s

  KOKKOS_FORCEINLINE_FUNCTION double middle() const { return 0.5 * (density_vapour + density_liquid); }

  /// Excess of the free energy of the homogeneous fluid, D(rho) = W(rho) - mu_s rho + p_s >= 0; scale a b^2.
  /// mu_s rho - p_s is the tangent of W at both phases: D is the height above it, taken from the phase that is closer.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N excess(const VanDerWaals& gas, const N& rho) const {
    const double r0 = gas.continuation;
    const auto low = rho < r0;
    const N r = select(low, N(r0), rho);
    const auto lower = rho < middle();
    const auto at_phase = [&](const auto& f) { return select(lower, N(f(density_vapour)), N(f(density_liquid))); };
    const N s = rho - r0;
    const N continued = s * (gas.derivative(r0) - potential + (0.5 * gas.curvature(r0)) * s);
    return gas.above_tangent(r, at_phase) + select(low, continued, N(0.0));
  }
};

/// <q, g^2 sqrt(|grad rho|^2 + d^2) cos(alpha)>_Gamma : the paper's law, grad rho . n = |grad rho| cos(alpha).
/// Source: Bueno et al. 2017, section 2.1.   Tested: tests/unit/fluid/test_contact_angle.cpp
struct GradientWall {
  static constexpr Where where = Where::wall;

  double capillarity = 0;
  double cosine = 0;     ///< cos(alpha), alpha measured in the liquid
  double smoothing = 0;  ///< d, scale b/L0

  template <class N, int D, class...>
  using Trial = DensityTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const DensityTrial<N, D>& t) const {
    const N slope = square_root(dot(t.density_gradient, t.density_gradient) + smoothing * smoothing);
    return {(capillarity * capillarity * cosine) * slope};
  }
};

/// <q, -f_w'(rho)>_Gamma with the wall energy f_w' = -cos(alpha) g sqrt(2 D(rho)): the variational equivalent.
/// sqrt(2 D) is smoothed as sqrt(2 D + d^2) - d, so that it vanishes and is differentiable in both phases.
struct EnergyWall {
  static constexpr Where where = Where::wall;

  double capillarity = 0;
  double cosine = 0;
  double smoothing = 1e-5;  ///< d, scale sqrt(a) b
  VanDerWaals gas;
  Coexistence state;

  template <class N, int D, class...>
  using Trial = DensityTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  /// -f_w'(rho), scale a b L0.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N force(const N& rho) const {
    const N excess = state.excess(gas, rho);
    const N safe = select(excess < 0.0, N(0.0), excess);  // rounding alone makes it negative
    return (capillarity * cosine) * (square_root(2.0 * safe + smoothing * smoothing) - smoothing);
  }

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const DensityTrial<N, D>& t) const {
    return {force(t.density)};
  }
};

}  // namespace softwet
