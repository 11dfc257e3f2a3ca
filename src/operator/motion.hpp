// The motion of the mesh: from the motion of the wall to the geometry at the points above it.
#pragma once

#include "kernels/point/geometry.hpp"
#include "operator/element.hpp"

namespace softwet {

/// Motion of the wall that moves the fluid mesh: control values of the wall's row per direction.
template <int D, class Real = double>
struct WallMotion {
  const Real* displacement[D];
  const Real* velocity[D];
  const Real* tangent[D];  ///< of the velocity, or null: geometry frozen
  Real scale;              ///< d displacement / d velocity
  Blend blend;
};

/// No motion: the map is the identity and nothing is read.
struct NoMotion {};

/// Geometry at a point of a fixed mesh.
template <class N, class S, int D>
KOKKOS_FORCEINLINE_FUNCTION FixedPoint<N, D> fixed_point(const Vector<S, D>& reference) {
  FixedPoint<N, D> point;
  for (int i = 0; i < D; ++i) {
    if constexpr (is_dual<N>) {
      point.position[i] = N(reference[i], S(0.0));
    } else {
      point.position[i] = reference[i];
    }
  }
  return point;
}

/// What the motion of the wall makes of a point above it.
template <class N, int D>
struct Blended {
  Matrix<N, D> gradient;  ///< F - I
  Vector<N, D> velocity, position;
};

/// From the motion of the wall below a point: displacement(i, c) and tangent(i, c) with c = 0 for the value and 1.. for
/// the slopes along the wall, and velocity(i). `scale` is d displacement / d velocity, `blend` a Blend or what answers
/// as one.
template <class N, class S, int D, class AsBlend, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION Blended<N, D> blended(const AsBlend& blend, Real scale, const Vector<S, D>& reference,
                                                  double height, const Wall& wall) {
  const Real beta = static_cast<Real>(blend.value(height)), slope = static_cast<Real>(blend.slope());
  const auto number = [&](const S& value, int i, int c, Real factor) {
    if constexpr (is_dual<N>) {
      return N(value, factor * wall.tangent(i, c));
    } else {
      return value;
    }
  };
  Blended<N, D> b;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j + 1 < D; ++j)
      b.gradient(i, j) = number(beta * wall.displacement(i, j + 1), i, j + 1, beta * scale);
    b.gradient(i, D - 1) = number(slope * wall.displacement(i, 0), i, 0, slope * scale);
    b.velocity[i] = number(beta * wall.velocity(i), i, 0, beta);
    b.position[i] = number(reference[i] + beta * wall.displacement(i, 0), i, 0, beta * scale);
  }
  return b;
}

/// Geometry at a point of the moving mesh.
template <class N, class S, int D, class AsBlend, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION MovingPoint<N, D> blended_point(const AsBlend& blend, Real scale,
                                                            const Vector<S, D>& reference, double height,
                                                            const Wall& wall) {
  const Blended<N, D> b = blended<N>(blend, scale, reference, height, wall);
  return MovingPoint<N, D>(b.gradient, b.velocity, b.position);
}
/// Geometry at a point of the moving mesh, or with `face` on the wall.
template <class N, bool face, class S, int D, class AsBlend, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION auto point_or_face(const AsBlend& blend, Real scale, const Vector<S, D>& reference,
                                               double height, const Wall& wall) {
  const MovingPoint<N, D> point = blended_point<N>(blend, scale, reference, height, wall);
  if constexpr (face) {
    return MovingFace<N, D>(point);
  } else {
    return point;
  }
}

/// Geometry at a point of the moving mesh in a volume, with its tangent in closed form.
template <class S, int D, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION VariedPoint<S, D> varied_point(const Blend& blend, Real scale,
                                                           const Vector<S, D>& reference, double height,
                                                           const Wall& wall) {
  const Blended<Dual<S>, D> b = blended<Dual<S>>(blend, scale, reference, height, wall);
  Matrix<S, D> f, df;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      f(i, j) = b.gradient(i, j).value;
      df(i, j) = b.gradient(i, j).tangent;
    }
  return VariedPoint<S, D>(f, df, b.velocity, b.position);
}

/// Geometry at the points of a batch on a fixed mesh.
template <class S, class N, int D, int P, int Q, class Motion>
struct BatchGeometry {
  KOKKOS_FORCEINLINE_FUNCTION BatchGeometry(const Region<D, RealOf<S>>&, const Batch<D>&, const AxisBasis<S, P, Q>&,
                                            const AxisBasis<RealOf<S>, P, Q>&, const Motion&) {}
  template <bool face>
  KOKKOS_FORCEINLINE_FUNCTION FixedPoint<N, D> at(int, const Vector<S, D>& reference, double) const {
    return fixed_point<N>(reference);
  }
};

/// Geometry of the blended moving mesh: the wall's motion interpolated along it, blended vertically at each point.
template <class S, class N, int D, int P, int Q, class Real>
struct BatchGeometry<S, N, D, P, Q, WallMotion<D, Real>> {
  static constexpr int wall_points = power(Q, D - 1);
  static constexpr int wall_controls = power(P + 1, D - 1);
  S displacement[D][D][wall_points];  // [direction][0: value, 1..: slopes along the wall]
  S velocity[D][wall_points];
  S tangent[is_dual<N> ? D : 1][D][wall_points];
  Real scale;
  Blend blend;

  KOKKOS_FORCEINLINE_FUNCTION BatchGeometry(const Region<D, Real>& region, const Batch<D>& b,
                                            const AxisBasis<S, P, Q>& x, const AxisBasis<Real, P, Q>& y,
                                            const WallMotion<D, Real>& wall)
      : scale(wall.scale), blend(wall.blend) {
    for (int d = 0; d < D; ++d) {
      trace(wall.displacement[d], region, b, x, y, displacement[d]);
      S v[D][wall_points];
      trace(wall.velocity[d], region, b, x, y, v);
      for (int q = 0; q < wall_points; ++q) velocity[d][q] = v[0][q];
      if constexpr (is_dual<N>) {
        if (wall.tangent[d]) {
          trace(wall.tangent[d], region, b, x, y, tangent[d]);
        } else {
          for (int c = 0; c < D; ++c)
            for (int q = 0; q < wall_points; ++q) tangent[d][c][q] = S(0.0);
        }
      }
    }
  }

  /// Value and slopes along the wall of one field of the wall's row.
  KOKKOS_FORCEINLINE_FUNCTION void trace(const Real* p, const Region<D, Real>& region, const Batch<D>& b,
                                         const AxisBasis<S, P, Q>& x, const AxisBasis<Real, P, Q>& y,
                                         S (&out)[D][wall_points]) const {
    constexpr int n = P + 1;
    S nodal[wall_controls];
    int first = b.element[0];
    if constexpr (D == 3) first += region.axis[1].first(b.element[1]) * region.stride[1];
    for (int a = 0; a < wall_controls; ++a)
      nodal[a] = load_lanes<S>(p + first + a % n + (D == 3 ? (a / n) * region.stride[1] : 0), b.count);
    if constexpr (D == 2) {
      for (int q = 0; q < Q; ++q) {
        out[0][q] = x.value[q][0] * nodal[0];
        out[1][q] = x.slope[q][0] * nodal[0];
        for (int i = 1; i < n; ++i) {
          out[0][q] = out[0][q] + x.value[q][i] * nodal[i];
          out[1][q] = out[1][q] + x.slope[q][i] * nodal[i];
        }
      }
    } else {
      interpolate<true, true, S, P, Q, Q>(nodal, x, y, out);
    }
  }

  /// The motion of the wall below point q.
  struct WallBelow {
    const BatchGeometry& g;
    int q;
    KOKKOS_FORCEINLINE_FUNCTION const S& displacement(int i, int c) const { return g.displacement[i][c][q]; }
    KOKKOS_FORCEINLINE_FUNCTION const S& velocity(int i) const { return g.velocity[i][q]; }
    KOKKOS_FORCEINLINE_FUNCTION const S& tangent(int i, int c) const { return g.tangent[is_dual<N> ? i : 0][c][q]; }
  };

  template <bool face>
  KOKKOS_FORCEINLINE_FUNCTION auto at(int q, const Vector<S, D>& reference, double height) const {
    const WallBelow wall{*this, q % wall_points};
    if constexpr (is_dual<N> && !face) {
      return varied_point(blend, scale, reference, height, wall);
    } else {
      return point_or_face<N, face>(blend, scale, reference, height, wall);
    }
  }
};

}  // namespace softwet
