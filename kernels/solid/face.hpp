// The deformed top face of the solid, by the slopes of the displacement along it.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// Tangents x_,a = e_a + u_,a, their products g_ab = x_,a . x_,b, and the ratio sqrt(det g) of the deformed to the
/// undeformed area. In the coordinates (r, z) they are those along r and z alone: the direction around the axis adds
/// the stretch r / R.
template <class N, int D>
struct Face {
  Vector<N, D> tangent[D - 1];  ///< x_,a
  N metric[3];                  ///< g_11; in 3D g_11, g_12, g_22
  N ratio;                      ///< a; in (r, z) |x'|

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION explicit Face(const M& grad_u) {
    SOFTWET_UNROLL
    for (int a = 0; a + 1 < D; ++a) SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) tangent[a][i] = i == a ? grad_u(i, a) + 1.0 : grad_u(i, a);
    metric[0] = dot(tangent[0], tangent[0]);
    if constexpr (D == 2) {
      ratio = square_root(metric[0]);
    } else {
      metric[1] = dot(tangent[0], tangent[1]);
      metric[2] = dot(tangent[1], tangent[1]);
      ratio = square_root(metric[0] * metric[2] - metric[1] * metric[1]);
    }
  }
};

}  // namespace softwet
