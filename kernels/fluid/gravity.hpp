// A uniform body force on the fluid.
#pragma once

#include "kernels/point/fluid_fields.hpp"

namespace softwet {

/// - (w, rho f) - (grad q, eps f) with f the force per unit mass, scale a b/L0, and eps = (C h^2 / m) rho^2. The second
/// part makes the stabilisation of `NavierStokesKorteweg` vanish at rest, where grad mu = f.
/// Tested: tests/unit/fluid/test_gravity.cpp, tests/verification/studies/gravity.py
struct Gravity {
  static constexpr Where where = Where::fluid;

  double force[3] = {0, 0, 0};
  double stabilisation = 0;  ///< C h^2 / m, as in NavierStokesKorteweg

  template <class N, int D>
  using Trial = DensityValueTrial<N, D>;
  template <class N, int D>
  using Test = ForceTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION ForceTest<N, D> residual(const DensityValueTrial<N, D>& t) const {
    const N eps = stabilisation * (t.density * t.density);
    ForceTest<N, D> r;
    for (int i = 0; i < D; ++i) {
      r.momentum[i] = -force[i] * t.density;
      r.mass_flux[i] = -force[i] * eps;
    }
    return r;
  }
};

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
struct GravityEnergy {
  static constexpr Where where = Where::fluid;

  Gravity gravity;

  static constexpr int count = 1;

  template <class N, int D>
  using Trial = PlacedDensity<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const PlacedDensity<N, D>& t) const {
    N height = gravity.force[0] * t.position[0];
    for (int i = 1; i < D; ++i) height = height + gravity.force[i] * t.position[i];
    return {{-1.0 * (t.density * height)}};
  }
};

}  // namespace softwet
