// Surface tension of the solid: the energy of its top face, Gamma.
#pragma once

#include "kernels/point/solid_fields.hpp"
#include "kernels/solid/face.hpp"

namespace softwet {

/// Energy Ups (a - 1) for each undeformed area, where a = sqrt(det g) is the deformed over the undeformed area, g_ab =
/// x_,a . x_,b, and x_,a = e_a + u_,a are the tangents of the deformed face. Its derivative is
///   int P_s : Grad w dA_0,   P_s(i, a) = Ups a g^ab x_i,b;   in 2D P_s = Ups x'/a
/// In the coordinates (r, z) a = |x'| r/R with the undeformed radius R: P_s = Ups (r/R) x'/|x'|, and w_r / R meets Ups
/// |x'|. Only slopes along the face enter. Ups is uniform: it is the tension of the dry face, and `WallTension` adds
/// the contribution of the fluid where it wets the face. Scale of Ups: a b^2 L0.
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct SurfaceTension {
  static constexpr Where where = Where::top;
  static constexpr const char* energy_column = "energy_surface";

  double tension = 0;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidStrain<N, D, M>& t) const {
    const Face<N, D> face(t.displacement_gradient);
    M flux;
    N scale = tension / face.ratio;
    if constexpr (is_axial_matrix<M>) {
      scale = scale * (1.0 + t.displacement_gradient.hoop);
      flux.hoop = tension * face.ratio;
    }
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      flux(i, D - 1) = N(0.0);
      if constexpr (D == 2) {
        flux(i, 0) = scale * face.tangent[0][i];
      } else {
        flux(i, 0) = scale * (face.metric[2] * face.tangent[0][i] - face.metric[1] * face.tangent[1][i]);
        flux(i, 1) = scale * (face.metric[0] * face.tangent[1][i] - face.metric[1] * face.tangent[0][i]);
      }
    }
    return MomentumTest<N, D, M>::of_flux(flux);
  }

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidStrain<N, D, M>& t) const {
    N ratio = Face<N, D>(t.displacement_gradient).ratio;
    if constexpr (is_axial_matrix<M>) ratio = ratio * (1.0 + t.displacement_gradient.hoop);
    return tension * (ratio - 1.0);
  }
};

}  // namespace softwet
