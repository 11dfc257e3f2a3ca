// The laws of the program with their stress from their energy alone, for comparison with the closed forms of kernels/.
#pragma once

#include "gradient.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/fluid/wall_energy.hpp"
#include "kernels/solid/elastodynamics.hpp"

namespace softwet {

/// What the energy of the wall asks of numbers, where a density is outside of its series too.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION bool any_nonzero(const Dual<S>& x) {
  return any_nonzero(x.value);
}
template <class N, int count>
KOKKOS_FORCEINLINE_FUNCTION bool any_nonzero(const Gradient<N, count>& x) {
  return any_nonzero(x.value);
}
template <class N, int count>
KOKKOS_FORCEINLINE_FUNCTION Gradient<N, count> half_logarithm_rest(const Gradient<N, count>& a,
                                                                   const Gradient<N, count>& b,
                                                                   const Gradient<N, count>& z) {
  Gradient<N, count> r(half_logarithm_rest(a.value, b.value, z.value));
  const N square = z.value * z.value;
  for (int k = 0; k < count; ++k) r.by[k] = 0.5 * square * square * (a.by[k] / a.value - b.by[k] / b.value);
  return r;
}

/// A material whose stress is the derivative of its energy.
template <class Material, Way way>
struct OfEnergy : Material {
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> first_piola(const Matrix<N, D>& grad_u) const {
    const Material& law = *this;
    return derivative<way, D>(grad_u, [&law](const auto& g) { return law.energy(g); });
  }
};
template <class Material, Way way>
using SolidOfEnergy = Elastodynamics<OfEnergy<Material, way>>;

/// A term of the solid that reads Grad u alone. One on its top face depends on slopes along the face.
template <class Term, Way way>
struct TermOfEnergy : Term {
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidStrain<N, D, M>& t) const {
    constexpr int columns = on_face(Term::where) ? D - 1 : D;
    const Term& law = *this;
    return MomentumTest<N, D, M>::of_flux(derivative<way, columns>(
        t.displacement_gradient, [&law]<class G>(const Matrix<G, D>& g) { return law.energy(SolidStrain<G, D>{g}); }));
  }
};

/// The fluid with W' as the derivative of W.
struct FluidOfEnergy : NavierStokesKorteweg {
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION FluidTest<N, D, M> residual(const FluidTrial<N, D, M>& t) const {
    FluidTest<N, D, M> r = NavierStokesKorteweg::residual(t);
    r.potential = t.chemical_potential - gas.energy(Gradient<N, 1>::variable(t.density, 0)).by[0];
    return r;
  }
};

/// The wall with -f_w' as the derivative of its energy, a series. For dual numbers `WallEnergy` itself takes the force.
struct WallOfEnergy {
  static constexpr Where where = Where::wall;

  WallEnergy energy;

  template <class N, int D, class...>
  using Trial = DensityTrial<N, D>;
  template <class N, int D, class...>
  using Test = WallTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION WallTest<N, D> residual(const DensityTrial<N, D>& t) const {
    return {-energy.value(Gradient<N, 1>::variable(t.density, 0)).by[0]};
  }
};

}  // namespace softwet
