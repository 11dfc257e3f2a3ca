// The energy of the fluid in a uniform body force, which `NavierStokesKorteweg` has.
#pragma once

#include "kernels/point/fluid_fields.hpp"

namespace softwet {

/// Density and where it is.
template <class N, int D>
struct PlacedDensity : DensityValueTrial<N, D> {
  Vector<N, D> position;  ///< x, L0

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION PlacedDensity read(const Reader& at) {
    return {DensityValueTrial<N, D>::read(at), at.position()};
  }
};

/// Potential energy - rho f . x per volume, scale a b^2: its integral changes as the work of the force.
/// Tested: tests/unit/fluid/test_gravity.cpp, tests/verification/studies/gravity.py
struct GravityEnergy {
  static constexpr Where where = Where::fluid;

  double force[3] = {0, 0, 0};  ///< f, scale a b/L0

  static constexpr int count = 1;
  static constexpr const char* column(int) { return "energy_gravity"; }

  template <class N, int D, class...>
  using Trial = PlacedDensity<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const PlacedDensity<N, D>& t) const {
    N height = force[0] * t.position[0];
    for (int i = 1; i < D; ++i) height = height + force[i] * t.position[i];
    return {{-1.0 * (t.density * height)}};
  }
};

}  // namespace softwet
