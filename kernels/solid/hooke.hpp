// Linear elasticity: the limit of every isotropic material for small strains.
#pragma once

#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// P = lambda tr(e) I + 2 G e of the strain e = (Grad u + Grad u^T)/2; all stresses are the same. 2D: plane strain.
/// Source: Landau and Lifshitz, Theory of Elasticity, section 4.   Tested: tests/unit/solid/test_hooke.cpp
struct Hooke : LameParameters {
  static constexpr const char* name = "hooke";

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M strain(const M& grad_u) const {
    return 0.5 * (grad_u + transpose(grad_u));
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION M first_piola(const M& grad_u) const {
    return linear_stress(*this, strain(grad_u));
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION auto energy(const M& grad_u) const {
    return quadratic_energy(*this, strain(grad_u));
  }
};

}  // namespace softwet
