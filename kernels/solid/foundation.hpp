// A foundation of springs and dashpots below the solid (Winkler, Kelvin and Voigt).
#pragma once

#include "kernels/point/vector_fields.hpp"

namespace softwet {

/// What a horizontal face has across and along itself, k_n and k_t: k a = k_n a_n n + k_t a_t of a vector a.
struct FaceModuli {
  double normal = 0;      ///< k_n
  double tangential = 0;  ///< k_t

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> times(const Vector<N, D>& a) const {
    Vector<N, D> r;
    for (int i = 0; i < D; ++i) r[i] = (i == D - 1 ? normal : tangential) * a[i];
    return r;
  }
};

/// <w, kap_n u_n n + kap_t u_t> over the undeformed bottom of the solid, whose normal n is vertical: the derivative of
/// the energy (kap_n u_n^2 + kap_t |u_t|^2)/2 of each undeformed area. The springs are linear at any displacement, push
/// and pull alike, and those across and along the face know nothing of each other.
/// Scale of kap_n and kap_t: a b^2/L0.   Source: Winkler's foundation.   Tested: tests/unit/solid/test_solid_terms.cpp
struct Foundation {
  static constexpr Where where = Where::bottom;
  static constexpr const char* energy_column = "energy_foundation";

  FaceModuli stiffness;  ///< kap_n, kap_t

  template <class N, int D, class...>
  using Trial = SolidDisplacement<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const SolidDisplacement<N, D>& u) const {
    return {stiffness.times(u.vector)};
  }
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidDisplacement<N, D>& u) const {
    return 0.5 * dot(stiffness.times(u.vector), u.vector);
  }
};

/// <w, c_n v_n n + c_t v_t> over the undeformed bottom of the solid, with springs or without. It dissipates c_n v_n^2 +
/// c_t |v_t|^2 >= 0 for each undeformed area. Scale of c_n and c_t: b sqrt(ab).
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct Dashpots {
  static constexpr Where where = Where::bottom;
  static constexpr const char* dissipation_column = "dissipation_solid";

  FaceModuli viscosity;  ///< c_n, c_t

  template <class N, int D, class...>
  using Trial = SolidVelocity<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const SolidVelocity<N, D>& v) const {
    return {viscosity.times(v.vector)};
  }
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N dissipation(const SolidVelocity<N, D>& v) const {
    return dot(viscosity.times(v.vector), v.vector);
  }
};

}  // namespace softwet
