// A solid whose stiffness varies in space, and which may be stretched before the scene begins.
#pragma once

#include "kernels/point/given_fields.hpp"
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

/// A law that is chosen at run time, so that one kernel serves all, of a solid with a prestretch.
struct ChosenMaterial {
  ElasticLaw law = ElasticLaw::saint_venant_kirchhoff;
  LameParameters stiffness;
  Prestretch prestretch = {};

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    return prestretch.first_piola(stress_of_law(prestretch.whole(grad_u)));
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy(const M& grad_u) const {
    return prestretch.energy(energy_of_law(prestretch.whole(grad_u)));
  }

 private:
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy_of_law(const M& g) const {
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

/// Momentum balance of the solid, (w, rho_0 v_t) + (Grad w, s P), with the stiffness s(X) over that of the material.
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct GradedSolid : Elastodynamics<ChosenMaterial> {
  template <class N, int D, class M = Matrix<N, D>>
  using Trial = WithGiven<SolidTrial<N, D, M>, N>;
  template <class N, int D, class M = Matrix<N, D>>
  using EnergyTrial = WithGiven<SolidStrain<N, D, M>, N>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const WithGiven<SolidTrial<N, D, M>, N>& t) const {
    MomentumTest<N, D, M> r = Elastodynamics::residual(t.trial);
    r.momentum_flux = t.given * r.momentum_flux;
    return r;
  }
  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const WithGiven<SolidStrain<N, D, M>, N>& t) const {
    return t.given * Elastodynamics::energy(t.trial);
  }
};

/// The part of a solid that takes means over its elements: `SelectiveParts::of_means`, without inertia.
struct SolidOfMeans : GradedSolid {
  static constexpr Where where = Where::means;
};

}  // namespace softwet
