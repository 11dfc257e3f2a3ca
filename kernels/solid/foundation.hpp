// A foundation of springs and dashpots below the solid (Winkler, Kelvin and Voigt).
#pragma once

#include "kernels/point/solid_fields.hpp"
#include "kernels/point/vector_fields.hpp"

namespace softwet {

/// <w, kap_n u_n n + kap_t u_t> over the undeformed bottom of the solid, whose normal n is vertical: the derivative of the energy
/// (kap_n u_n^2 + kap_t |u_t|^2)/2 of each undeformed area. The springs are linear at any displacement, push and pull alike, and those
/// across and along the face know nothing of each other.
/// Scale of kap_n and kap_t: a b^2/L0.   Source: Winkler's foundation.   Tested: tests/unit/solid/test_solid_terms.cpp
struct Foundation {
  static constexpr Where where = Where::bottom;
  static constexpr const char* energy_column = "energy_foundation";

  double normal = 0;      ///< kap_n
  double tangential = 0;  ///< kap_t

  template <class N, int D, class...>
  using Trial = SolidDisplacement<N, D>;
  template <class N, int D, class...>
  using EnergyTrial = SolidDisplacement<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const SolidDisplacement<N, D>& t) const {
    VectorTest<N, D> r;
    for (int i = 0; i < D; ++i) r.value[i] = (i == D - 1 ? normal : tangential) * t.displacement[i];
    return r;
  }

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidDisplacement<N, D>& t) const {
    return 0.5 * dot(residual(t).value, t.displacement);
  }
};

/// <w, c_n v_n n + c_t v_t> over the undeformed bottom of the solid, beside the springs or alone. It dissipates c_n v_n^2 + c_t |v_t|^2
/// >= 0 for each undeformed area.
/// Scale of c_n and c_t: b sqrt(ab).   Tested: tests/unit/solid/test_solid_terms.cpp
struct Dashpots {
  static constexpr Where where = Where::bottom;
  static constexpr const char* dissipation_column = "dissipation_solid";

  double normal = 0;      ///< c_n
  double tangential = 0;  ///< c_t

  template <class N, int D, class...>
  using Trial = SolidVelocity<N, D>;
  template <class N, int D, class...>
  using Test = VectorTest<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION VectorTest<N, D> residual(const SolidVelocity<N, D>& t) const {
    VectorTest<N, D> r;
    for (int i = 0; i < D; ++i) r.value[i] = (i == D - 1 ? normal : tangential) * t.velocity[i];
    return r;
  }

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION N dissipation(const SolidVelocity<N, D>& t) const {
    return dot(residual(t).value, t.velocity);
  }
};

}  // namespace softwet
