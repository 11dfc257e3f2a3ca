// One batch of elements: control values -> fields at points -> reader for a term -> integrals back to control values.
#pragma once

#include "kernels/basis/contract.hpp"
#include "kernels/point/fields.hpp"
#include "kernels/point/geometry.hpp"
#include "spline/region.hpp"

namespace softwet {

/// Where the lanes of a batch sit: elements (x .. x + count - 1, y, z) of a region.
template <int D>
struct Batch {
  int element[D];
  int count;
};

/// Reads `count` lanes from p[0..]; further lanes repeat the last one.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION S load_lanes(const RealOf<S>* p, int count) {
  constexpr int lanes = Lanes<S>::count;
  if (lanes == 1 || count == lanes) return load<S>(p);
  RealOf<S> lane[lanes];
  for (int l = 0; l < lanes; ++l) lane[l] = p[l < count ? l : count - 1];
  return load<S>(lane);
}

template <class S>
KOKKOS_FORCEINLINE_FUNCTION void add_lanes(RealOf<S>* p, const S& x, int count) {
  constexpr int lanes = Lanes<S>::count;
  if (lanes == 1 || count == lanes) return add_to(p, x);
  if constexpr (lanes > 1)
    for (int l = 0; l < count; ++l) p[l] += x[l];
}

template <class S, int P, int Q>
KOKKOS_FORCEINLINE_FUNCTION AxisBasis<S, P, Q> load_basis(const AxisRuleOf<RealOf<S>>& rule, int element) {
  AxisBasis<S, P, Q> b;
  for (int q = 0; q < Q; ++q)
    for (int a = 0; a <= P; ++a) {
      b.value[q][a] = load<S>(&rule.value(q, a, element));
      b.slope[q][a] = load<S>(&rule.slope(q, a, element));
    }
  return b;
}

/// The 1D bases of a batch; `test` differs from the last axis' trial basis where the test space is restricted.
template <class S, int D, int P, int Q, int QL>
struct BatchBasis {
  using Real = RealOf<S>;
  AxisBasis<S, P, Q> x;
  AxisBasis<Real, P, Q> y;  // 3D only
  AxisBasis<Real, P, QL> last, test;

  KOKKOS_FORCEINLINE_FUNCTION BatchBasis(const Region<D, Real>& region, const Batch<D>& b)
      : x(load_basis<S, P, Q>(region.axis[0], b.element[0])),
        last(load_basis<Real, P, QL>(region.axis[D - 1], b.element[D - 1])),
        test(load_basis<Real, P, QL>(region.test, b.element[D - 1])) {
    if constexpr (D == 3) y = load_basis<Real, P, Q>(region.axis[1], b.element[1]);
  }
  template <bool Value, bool Gradient>
  KOKKOS_FORCEINLINE_FUNCTION void forward(const S (&nodal)[power(P + 1, D)], S (*out)[power(Q, D - 1) * QL]) const {
    if constexpr (D == 2) {
      interpolate<Value, Gradient, S, P, Q, QL>(nodal, x, last, out);
    } else {
      interpolate<Value, Gradient, S, P, Q, QL>(nodal, x, y, last, out);
    }
  }
  template <bool Gradient>
  KOKKOS_FORCEINLINE_FUNCTION void backward(const S (*in)[power(Q, D - 1) * QL], S (&nodal)[power(P + 1, D)]) const {
    if constexpr (D == 2) {
      integrate<Gradient, S, P, Q, QL>(in, x, test, nodal);
    } else {
      integrate<Gradient, S, P, Q, QL>(in, x, y, test, nodal);
    }
  }
};

/// Offset of a batch's first control value in a component.
template <int D, class Real>
KOKKOS_FORCEINLINE_FUNCTION int first_control(const Region<D, Real>& region, const Batch<D>& b) {
  int offset = b.element[0];
  for (int d = 1; d < D; ++d) offset += region.axis[d].first(b.element[d]) * region.stride[d];
  return offset;
}

/// The same for the test functions.
template <int D, class Real>
KOKKOS_FORCEINLINE_FUNCTION int first_test(const Region<D, Real>& region, const Batch<D>& b) {
  const int last = b.element[D - 1];
  return first_control(region, b) + (region.test.first(last) - region.axis[D - 1].first(last)) * region.stride[D - 1];
}

template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void gather(const RealOf<S>* p, const Region<D, RealOf<S>>& region, int first, int count,
                                        S (&nodal)[power(P + 1, D)]) {
  constexpr int n = P + 1;
  for (int k = 0; k < (D == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        nodal[(k * n + j) * n + i] =
            load_lanes<S>(p + first + i + j * region.stride[1] + (D == 3 ? k * region.stride[D - 1] : 0), count);
}

template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void scatter(RealOf<S>* p, const Region<D, RealOf<S>>& region, int first, int count,
                                         const S (&nodal)[power(P + 1, D)]) {
  constexpr int n = P + 1;
  // Packs of neighbouring i overlap in memory: with i outermost a pack is stored long before its lanes are read again.
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < (D == 3 ? n : 1); ++k)
      for (int j = 0; j < n; ++j)
        add_lanes(p + first + i + j * region.stride[1] + (D == 3 ? k * region.stride[D - 1] : 0),
                  nodal[(k * n + j) * n + i], count);
}

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

/// Geometry at a point of the moving mesh, from the motion of the wall below it: displacement(i, c) and tangent(i, c) with
/// c = 0 for the value and 1.. for the slopes along the wall, and velocity(i). `scale` is d displacement / d velocity.
template <class N, class S, int D, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION MovingPoint<N, D> blended_point(const Blend& blend, Real scale,
                                                            const Vector<S, D>& reference, double height,
                                                            const Wall& wall, bool face) {
  const Real beta = static_cast<Real>(blend.value(height)), slope = static_cast<Real>(blend.slope());
  const auto number = [&](const S& value, int i, int c, Real factor) {
    if constexpr (is_dual<N>) {
      return N(value, factor * wall.tangent(i, c));
    } else {
      return value;
    }
  };
  Matrix<N, D> f;
  Vector<N, D> v, x;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j + 1 < D; ++j) f(i, j) = number(beta * wall.displacement(i, j + 1), i, j + 1, beta * scale);
    f(i, D - 1) = number(slope * wall.displacement(i, 0), i, 0, slope * scale);
    v[i] = number(beta * wall.velocity(i), i, 0, beta);
    x[i] = number(reference[i] + beta * wall.displacement(i, 0), i, 0, beta * scale);
  }
  return MovingPoint<N, D>(f, v, x, face);
}

/// The same with its tangent in closed form, in a volume.
template <class S, int D, class Real, class Wall>
KOKKOS_FORCEINLINE_FUNCTION VariedPoint<S, D> varied_point(const Blend& blend, Real scale,
                                                           const Vector<S, D>& reference, double height,
                                                           const Wall& wall) {
  const Real beta = static_cast<Real>(blend.value(height)), slope = static_cast<Real>(blend.slope());
  Matrix<S, D> f, df;
  Vector<Dual<S>, D> v, x;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j + 1 < D; ++j) {
      f(i, j) = beta * wall.displacement(i, j + 1);
      df(i, j) = (beta * scale) * wall.tangent(i, j + 1);
    }
    f(i, D - 1) = slope * wall.displacement(i, 0);
    df(i, D - 1) = (slope * scale) * wall.tangent(i, 0);
    v[i] = {beta * wall.velocity(i), beta * wall.tangent(i, 0)};
    x[i] = {reference[i] + beta * wall.displacement(i, 0), (beta * scale) * wall.tangent(i, 0)};
  }
  return VariedPoint<S, D>(f, df, v, x);
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
      return blended_point<N>(blend, scale, reference, height, wall, face);
    }
  }
};

}  // namespace softwet
