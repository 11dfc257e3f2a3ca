// Elasticity of the solid's surface: its top face resists stretch and shear along itself.
#pragma once

#include "kernels/point/solid_fields.hpp"
#include "kernels/solid/face.hpp"
#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// Energy lambda_s/2 (tr E_s)^2 + G_s E_s : E_s for each undeformed area of the top face, with the Green strain of the
/// face, E_s,ab = (x_,a . x_,b - delta_ab)/2, which is the part along the face of the strain of the solid. Its
/// derivative is
///   int P_s : Grad w dA_0,   P_s(i, a) = x_i,b S_ab,   S = lambda_s tr(E_s) 1 + 2 G_s E_s, the second Piola-Kirchhoff
///     stress
/// In 2D the strain is plane, and S = (lambda_s + 2 G_s) (|x'|^2 - 1)/2. In the coordinates (r, z) the strain around
/// the axis is ((r/R)^2 - 1)/2, and its stress meets (r/R) w_r / R. Only slopes along the face enter, and they enter in
/// full even where the solid has small strains. Scale of lambda_s and G_s: a b^2 L0.   Source: Gurtin and Murdoch's
/// surfaces, in the material form.
/// Tested: tests/unit/solid/test_solid_terms.cpp
struct SurfaceElasticity {
  static constexpr Where where = Where::top;
  static constexpr const char* energy_column = "energy_surface";

  double lambda = 0;         ///< lambda_s
  double shear_modulus = 0;  ///< G_s

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const SolidStrain<N, D, M>& t) const {
    const Face<N, D> face(t.displacement_gradient);
    const M strain = green_lagrange_strain(t.displacement_gradient);
    const N normal = lambda * trace_along<N, D>(strain);
    M flux;
    if constexpr (is_axial_matrix<M>)
      flux.hoop = (normal + (2.0 * shear_modulus) * strain.hoop) * (1.0 + t.displacement_gradient.hoop);
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      flux(i, D - 1) = N(0.0);
      SOFTWET_UNROLL
      for (int a = 0; a + 1 < D; ++a) {
        flux(i, a) = normal * face.tangent[a][i];
        SOFTWET_UNROLL
        for (int b = 0; b + 1 < D; ++b)
          flux(i, a) = flux(i, a) + (2.0 * shear_modulus) * (strain(a, b) * face.tangent[b][i]);
      }
    }
    return MomentumTest<N, D, M>::of_flux(flux);
  }

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const SolidStrain<N, D, M>& t) const {
    const M strain = green_lagrange_strain(t.displacement_gradient);
    const N tr = trace_along<N, D>(strain);
    N square = strain(0, 0) * strain(0, 0);
    if constexpr (D == 3) square = square + 2.0 * (strain(0, 1) * strain(0, 1)) + strain(1, 1) * strain(1, 1);
    if constexpr (is_axial_matrix<M>) square = square + strain.hoop * strain.hoop;
    return (0.5 * lambda) * (tr * tr) + shear_modulus * square;
  }

 private:
  /// tr E_s
  template <class N, int D, class M>
  static KOKKOS_FORCEINLINE_FUNCTION N trace_along(const M& strain) {
    N sum = strain(0, 0);
    if constexpr (D == 3) sum = sum + strain(1, 1);
    if constexpr (is_axial_matrix<M>) sum = sum + strain.hoop;
    return sum;
  }
};

}  // namespace softwet
