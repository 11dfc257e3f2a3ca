// A spring between a moving position and the displacement of a solid: what holds a needle's box.
#pragma once

#include "kernels/algebra/dual.hpp"

namespace softwet {

/// For each volume of the undeformed solid, with the gap from the displacement u to the position U, gap = U - u:
///   energy k/2 |gap|^2,   force on the solid k gap = - d energy / d u,   power of the motion k gap . U'
/// So the energy grows by the power of the motion minus the work of the force on the solid, k gap . u'. Along each axis
/// by itself.
/// Tested: tests/unit/solid/test_spring.cpp
struct Spring {
  double stiffness = 0;  ///< k, scale a b^2/L0^2

  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const N& gap) const {
    return (0.5 * stiffness) * (gap * gap);
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N force(const N& gap) const {
    return stiffness * gap;
  }
};

}  // namespace softwet
