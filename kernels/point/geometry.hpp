// Geometry at a point: the map from reference to current coordinates, and what it does to gradients and measures.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// Vertical blending of the wall's motion into the fluid mesh: displacement(x, y) = d(x) (1 - eta(y)).
/// The control points of row j move by (1 - Greville height) times the wall's, which is this linear blend exactly.
struct Blend {
  double low = 0;     ///< height of the wall
  double height = 1;  ///< of the fluid
  KOKKOS_FORCEINLINE_FUNCTION double value(double y) const { return 1.0 - (y - low) / height; }
  KOKKOS_FORCEINLINE_FUNCTION double slope() const { return -1.0 / height; }
};

/// Identity map: a fixed mesh, or the reference configuration of the solid.
template <class N, int D>
struct FixedPoint {
  Vector<N, D> position;  ///< x

  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& g) const { return g; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const { return f; }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const { return x; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const {
    Vector<N, D> zero;
    for (int i = 0; i < D; ++i) zero[i] = N(0.0);
    return zero;
  }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return N(1.0); }
};

/// Moving map x = X + d(X): F = I + Grad d, cof F = J F^-T.
///   grad_x g = F^-T Grad g,    integral of flux . grad_x q dx = integral of (cof F^T flux) . Grad q dX
template <class N, int D>
struct MovingPoint {
  Matrix<N, D> cofactors;  ///< cof F
  N volume;                ///< J = det F
  N inverse_volume;        ///< 1 / J
  Vector<N, D> velocity;   ///< mesh velocity
  Vector<N, D> position;   ///< x

  /// @param gradient  F - I
  KOKKOS_FORCEINLINE_FUNCTION MovingPoint(const Matrix<N, D>& gradient, const Vector<N, D>& mesh_velocity,
                                          const Vector<N, D>& place)
      : velocity(mesh_velocity), position(place) {
    const Matrix<N, D> f = add_diagonal(gradient, 1.0);
    cofactors = cofactor(f);
    volume = determinant(f, cofactors);
    inverse_volume = 1.0 / volume;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& g) const {
    return inverse_volume * product(cofactors, g);
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const {
    return product(transpose(cofactors), f);
  }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const { return volume * x; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return velocity; }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return volume; }
};

/// The moving map on a face of the last axis: integrals are over its deformed area, |cof F e_D| times the undeformed
/// one. Fluxes are tangential there, as P_Gamma = 1 - n n is: only slopes along the face meet them.
template <class N, int D>
struct MovingFace : MovingPoint<N, D> {
  N measure;            ///< |cof F e_D|
  Vector<N, D> normal;  ///< n, unit vector

  KOKKOS_FORCEINLINE_FUNCTION MovingFace(const MovingPoint<N, D>& point) : MovingPoint<N, D>(point) {
    for (int i = 0; i < D; ++i) normal[i] = this->cofactors(i, D - 1);
    measure = square_root(dot(normal, normal));
    normal = (1.0 / measure) * normal;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const {
    Vector<N, D> r = (measure * this->inverse_volume) * product(transpose(this->cofactors), f);
    r[D - 1] = N(0.0);
    return r;
  }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const { return measure * x; }
  KOKKOS_FORCEINLINE_FUNCTION N area_ratio() const { return measure; }  ///< of the deformed over the undeformed area
};

/// A point in the coordinates (r, z), where r is its distance from the axis: of the moved mesh in the fluid, undeformed
/// in the solid. Integrals have the weight r, those over the angle are left out. A test function w of the radial
/// component has a further gradient w / r, which meets the hoop entry of a flux.
template <class Point>
struct AxialPoint : Point {
  using Number = std::remove_cvref_t<decltype(std::declval<Point>().position[0])>;
  Number undeformed_radius;

  template <class S>
  KOKKOS_FORCEINLINE_FUNCTION AxialPoint(const Point& point, const S& undeformed) : Point(point) {
    if constexpr (is_dual<Number>) {
      undeformed_radius = Number(undeformed, S(0.0));
    } else {
      undeformed_radius = undeformed;
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION const auto& radius() const { return this->position[0]; }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION auto measured(const N& x) const {
    return Point::measured(radius() * x);
  }
  /// Integrand against (w, w / r).
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION auto measured(const N& x, const N& hoop) const {
    return Point::measured(radius() * x + hoop);
  }
  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION auto reference_flux(const Vector<N, D>& f) const {
    return Point::reference_flux(radius() * f);
  }
  /// On a face, with the stretch around the axis.
  KOKKOS_FORCEINLINE_FUNCTION auto area_ratio() const { return Point::area_ratio() * (radius() / undeformed_radius); }
};

/// The moving map in a volume together with its tangent dF, for products with the Jacobian: what dual numbers in a
/// `MovingPoint` would compute, with fewer operations. With A = F^-T, H = A dF^T and dJ = J tr H,
///   d(A Grad) = A d(Grad) - H (A Grad),    d(J A^T f) = J A^T (df + tr H f - H^T f)
/// Fluxes and integrands are handed out as their tangents alone.   Tested: tests/unit/point/test_geometry.cpp
template <class S, int D>
struct VariedPoint {
  using N = Dual<S>;
  Matrix<S, D> inverse;   ///< A
  Matrix<S, D> change;    ///< H
  N volume;               ///< J and dJ
  S growth;               ///< tr H
  Vector<N, D> velocity;  ///< mesh velocity
  Vector<N, D> position;  ///< x

  /// @param gradient, tangent  F - I and dF
  KOKKOS_FORCEINLINE_FUNCTION VariedPoint(const Matrix<S, D>& gradient, const Matrix<S, D>& tangent,
                                          const Vector<N, D>& mesh_velocity, const Vector<N, D>& place)
      : velocity(mesh_velocity), position(place) {
    const Matrix<S, D> f = add_diagonal(gradient, 1.0), cofactors = cofactor(f);
    volume = N(determinant(f, cofactors), contract(cofactors, tangent));
    const S inverse_volume = 1.0 / volume.value;
    inverse = inverse_volume * cofactors;
    change = product(inverse, transpose(tangent));
    growth = inverse_volume * volume.tangent;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& reference) const {
    Vector<S, D> value, tangent;
    for (int i = 0; i < D; ++i) {
      value[i] = reference[i].value;
      tangent[i] = reference[i].tangent;
    }
    const Vector<S, D> g = product(inverse, value);
    return join(g, product(inverse, tangent) - product(change, g));
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<S, D> reference_flux(const Vector<N, D>& f) const {
    Vector<S, D> value, tangent;
    for (int i = 0; i < D; ++i) {
      value[i] = f[i].value;
      tangent[i] = f[i].tangent + growth * f[i].value;
    }
    return volume.value * product(transpose(inverse), tangent - product(transpose(change), value));
  }
  KOKKOS_FORCEINLINE_FUNCTION S measured(const N& x) const {
    return volume.value * x.tangent + volume.tangent * x.value;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return velocity; }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return volume; }
};

}  // namespace softwet
