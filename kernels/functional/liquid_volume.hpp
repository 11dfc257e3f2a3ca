// The volume of the liquid in a fluid of two phases.
#pragma once

#include "kernels/algebra/pack.hpp"

namespace softwet {

/// Share of liquid at a point; its integral over the current fluid domain is the volume. It is s^2 (3 - 2 s) with s =
/// (rho - rho_v) / (rho_l - rho_v), where s is 0 below the density of the vapour and 1 above the density of the liquid.
/// It is 1/2 at the surface, as s is, and its slope is 0 in both phases, so that vapour a little denser than rho_v, as
/// around a small droplet, hardly counts.
/// Tested: tests/unit/functional/test_integrals.cpp
struct LiquidVolume {
  double vapour = 0, liquid = 1;  ///< densities rho_v and rho_l of the phases in equilibrium

  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N of(const N& density) const {
    const N share = (density - vapour) * (1 / (liquid - vapour));
    const N above = select(share < 0.0, N(0.0), share), s = select(above < 1.0, above, N(1.0));
    return s * s * (3.0 - 2.0 * s);
  }
};

}  // namespace softwet
