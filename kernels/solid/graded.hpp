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

/// A law that is chosen at run time, so that one kernel serves all laws, of a solid with a prestretch. One part of a
/// solid may carry a uniform stress for another one, diag(c): psi + c : Grad u and P + diag(c). This leaves the stress
/// of all parts together unchanged.
struct ChosenMaterial {
  ElasticLaw law = ElasticLaw::saint_venant_kirchhoff;
  LameParameters stiffness;
  Prestretch prestretch = {};
  Vector<double, 3> carried{{0, 0, 0}};  ///< c along the axes; in (r, z) the third is that around the axis

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    return with_carried(prestretch.first_piola(stress_of_law(prestretch.whole(grad_u))));
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy(const M& grad_u) const {
    return prestretch.energy(energy_of_law(prestretch.whole(grad_u))) + work_of_carried(grad_u);
  }

 private:
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> with_carried(Matrix<N, D> p) const {
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) p(i, i) = p(i, i) + carried[i];
    return p;
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> with_carried(const AxialMatrix<N>& p) const {
    return {with_carried(p.plane), p.hoop + carried[2]};
  }
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N work_of_carried(const Matrix<N, D>& grad_u) const {
    N sum = carried[0] * grad_u(0, 0);
    SOFTWET_UNROLL
    for (int i = 1; i < D; ++i) sum = sum + carried[i] * grad_u(i, i);
    return sum;
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N work_of_carried(const AxialMatrix<N>& grad_u) const {
    return work_of_carried(grad_u.plane) + carried[2] * grad_u.hoop;
  }
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

/// Momentum balance of the solid, (w, rho_0 v_t) + (Grad w, s P), with s(X) the stiffness over the stiffness of the
/// material.
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
