// A term of tests whose channels have unlike integrands: one against values alone, one against values and slopes.
#pragma once

#include "kernels/fluid/navier_stokes_korteweg.hpp"

namespace softwet::testing_tools {

template <class N, int D>
struct MixedTest {
  N momentum, mass;
  Vector<N, D> mass_flux;

  static constexpr int channel_count = 2;
  static constexpr bool has_flux = true;
  static constexpr bool flux_of(int c) { return c == 1; }
  static constexpr Component channel(int c) {
    return c == 0 ? Component{Field::velocity, 0} : Component{Field::density};
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    Vector<N, D> none;
    for (int i = 0; i < D; ++i) none[i] = N(0.0);
    to.add(0, momentum, none);
    to.add(1, mass, mass_flux);
  }
};

struct MixedChannels {
  static constexpr Where where = Where::fluid;

  template <class N, int D, class...>
  using Trial = DensityTrial<N, D>;
  template <class N, int D, class...>
  using Test = MixedTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION MixedTest<N, D> residual(const DensityTrial<N, D>& t) const {
    return {t.density * t.density, 0.7 * t.density, t.density * t.density_gradient};
  }
};

}  // namespace softwet::testing_tools
