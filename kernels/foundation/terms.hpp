// A foundation of springs and dashpots below the solid (Winkler, Kelvin and Voigt).
#pragma once

#include "kernels/point/vector_fields.hpp"

namespace softwet {

/// <w, k_n a_n n + k_t a_t> over the undeformed bottom of the solid, whose normal n is vertical, for a vector a. What
/// acts across the face and what acts along it know nothing of each other.
/// @tparam Of  SolidDisplacement or SolidVelocity
template <template <class, int> class Of>
struct BelowSolid {
  static constexpr Where where = Where::bottom;

  double normal = 0;      ///< k_n
  double tangential = 0;  ///< k_t

  template <class N, int D, class...>
  using Trial = Of<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const Of<N, D>& a) const {
    VectorTest<N, D> r;
    for (int i = 0; i < D; ++i) r.value[i] = (i == D - 1 ? normal : tangential) * a.vector[i];
    return r;
  }
  /// What bounds explicit steps.
  double rate() const { return normal < tangential ? tangential : normal; }
};

/// Springs with the energy (kap_n u_n^2 + kap_t |u_t|^2)/2 of each undeformed area. They are linear at any
/// displacement, and push and pull alike.
/// Scale of kap_n and kap_t: a b^2/L0.   Source: Winkler's foundation.   Tested: tests/unit/solid/test_solid_terms.cpp
struct Foundation : BelowSolid<SolidDisplacement> {
  static constexpr const char *name = "foundation", *energy_column = "energy_foundation";

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidDisplacement<N, D>& u) const {
    return 0.5 * dot(residual(u).value, u.vector);
  }
};

/// Dashpots, with springs or without, that dissipate c_n v_n^2 + c_t |v_t|^2 >= 0 for each undeformed area.
/// Scale of c_n and c_t: b sqrt(ab).   Tested: tests/unit/solid/test_solid_terms.cpp
struct Dashpots : BelowSolid<SolidVelocity> {
  static constexpr const char *name = "dashpots of the foundation", *dissipation_column = "dissipation_solid";

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N dissipation(const SolidVelocity<N, D>& v) const {
    return dot(residual(v).value, v.vector);
  }
};

/// The terms of a foundation.
struct FoundationTerms {
  /// Calls use(term) for those that a case has. @param part  its springs and dashpots, two numbers each or none
  template <class Part, class Use>
  static void of(const Part& part, const Use& use) {
    if (!part.springs.empty()) use(Foundation{part.springs[0], part.springs[1]});
    if (!part.dashpots.empty()) use(Dashpots{part.dashpots[0], part.dashpots[1]});
  }
};

}  // namespace softwet
