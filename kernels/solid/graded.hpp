// A solid whose stiffness varies in space, and which may be stretched before the scene begins.
#pragma once

#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/prestretch.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {

enum class ElasticLaw { saint_venant_kirchhoff, hooke, neo_hookean };
inline ElasticLaw law_of(const SaintVenantKirchhoff&) { return ElasticLaw::saint_venant_kirchhoff; }
inline ElasticLaw law_of(const Hooke&) { return ElasticLaw::hooke; }
inline ElasticLaw law_of(const NeoHookean&) { return ElasticLaw::neo_hookean; }

/// Momentum balance of the solid, (w, rho_0 v_t) + (Grad w, s P), with the stiffness s(X) over that of the material, and with the
/// prestretch. The law is chosen at run time, so that one kernel serves all.
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct GradedSolid {
  static constexpr Where where = Where::solid;
  static constexpr const char* energy_column = "energy_elastic";

  ElasticLaw law = ElasticLaw::saint_venant_kirchhoff;
  LameParameters stiffness;
  double density = 0;  ///< rho_0^s / b
  Prestretch prestretch = {};

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = GradedSolidTrial<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using EnergyTrial = GradedSolidStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const GradedSolidTrial<N, D, M>& t) const {
    return {density * t.solid.acceleration, t.stiffness * first_piola(t.solid.displacement_gradient)};
  }
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const GradedSolidStrain<N, D, M>& t) const {
    const N of_law = energy_of_law<N>(prestretch.whole(t.strain.displacement_gradient));
    return t.stiffness * prestretch.energy(of_law);
  }

 private:
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    return prestretch.first_piola(stress_of_law(prestretch.whole(grad_u)));
  }
  template <class N, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy_of_law(const M& g) const {
    if (law == ElasticLaw::hooke) return Hooke{stiffness}.energy(g);
    if (law == ElasticLaw::neo_hookean) return NeoHookean{stiffness}.energy(g);
    return SaintVenantKirchhoff{stiffness}.energy(g);
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M stress_of_law(const M& g) const {
    if (law == ElasticLaw::hooke) return Hooke{stiffness}.first_piola(g);
    if (law == ElasticLaw::neo_hookean) return NeoHookean{stiffness}.first_piola(g);
    return SaintVenantKirchhoff{stiffness}.first_piola(g);
  }
};

/// The part of a solid that takes means over its elements: `SelectiveParts::of_means`, without inertia.
struct SolidOfMeans : GradedSolid {
  static constexpr Where where = Where::means;
};

}  // namespace softwet
