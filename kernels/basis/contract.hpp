// Sum factorisation on one element: control values -> values and gradients at points, and the transpose.
#pragma once

#include "kernels/algebra/pack.hpp"

namespace softwet {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

/// B-spline values and slopes at the Q points of one element along one axis.
/// B is a scalar for the axes that all lanes share and a pack for the first axis.
template <class B, int P, int Q>
struct AxisBasis {
  B value[Q][P + 1];
  B slope[Q][P + 1];
};

/// Values at points and, if asked for, gradient: out[0][q], out[1 + axis][q]; points with the first axis fastest.
/// nodal: (P+1)^D control values, first axis fastest.
template <bool Value, bool Gradient, class S, int P, int Q, int QL>
KOKKOS_FORCEINLINE_FUNCTION void interpolate(const S (&nodal)[power(P + 1, 2)], const AxisBasis<S, P, Q>& x,
                                             const AxisBasis<RealOf<S>, P, QL>& y, S (*out)[Q * QL]) {
  for (int qx = 0; qx < Q; ++qx) {
    S v[P + 1], dx[P + 1];
    for (int j = 0; j <= P; ++j) {
      v[j] = x.value[qx][0] * nodal[j * (P + 1)];
      for (int i = 1; i <= P; ++i) v[j] = v[j] + x.value[qx][i] * nodal[j * (P + 1) + i];
      if constexpr (Gradient) {
        dx[j] = x.slope[qx][0] * nodal[j * (P + 1)];
        for (int i = 1; i <= P; ++i) dx[j] = dx[j] + x.slope[qx][i] * nodal[j * (P + 1) + i];
      }
    }
    for (int qy = 0; qy < QL; ++qy) {
      const int q = qy * Q + qx;
      if constexpr (Value) {
        S s = y.value[qy][0] * v[0];
        for (int j = 1; j <= P; ++j) s = s + y.value[qy][j] * v[j];
        out[0][q] = s;
      }
      if constexpr (Gradient) {
        S sx = y.value[qy][0] * dx[0], sy = y.slope[qy][0] * v[0];
        for (int j = 1; j <= P; ++j) {
          sx = sx + y.value[qy][j] * dx[j];
          sy = sy + y.slope[qy][j] * v[j];
        }
        out[1][q] = sx;
        out[2][q] = sy;
      }
    }
  }
}

template <bool Value, bool Gradient, class S, int P, int Q, int QL>
KOKKOS_FORCEINLINE_FUNCTION void interpolate(const S (&nodal)[power(P + 1, 3)], const AxisBasis<S, P, Q>& x,
                                             const AxisBasis<RealOf<S>, P, Q>& y, const AxisBasis<RealOf<S>, P, QL>& z,
                                             S (*out)[Q * Q * QL]) {
  constexpr int n = P + 1;
  S plane[n][3][Q * Q];
  for (int k = 0; k < n; ++k) {
    S layer[n * n];
    for (int a = 0; a < n * n; ++a) layer[a] = nodal[k * n * n + a];
    interpolate<true, Gradient, S, P, Q, Q>(layer, x, y, plane[k]);
  }
  for (int qz = 0; qz < QL; ++qz)
    for (int q = 0; q < Q * Q; ++q) {
      const int point = qz * Q * Q + q;
      S v = z.value[qz][0] * plane[0][0][q];
      for (int k = 1; k < n; ++k) v = v + z.value[qz][k] * plane[k][0][q];
      if constexpr (Value) out[0][point] = v;
      if constexpr (Gradient) {
        S dx = z.value[qz][0] * plane[0][1][q], dy = z.value[qz][0] * plane[0][2][q];
        S dz = z.slope[qz][0] * plane[0][0][q];
        for (int k = 1; k < n; ++k) {
          dx = dx + z.value[qz][k] * plane[k][1][q];
          dy = dy + z.value[qz][k] * plane[k][2][q];
          dz = dz + z.slope[qz][k] * plane[k][0][q];
        }
        out[1][point] = dx;
        out[2][point] = dy;
        out[3][point] = dz;
      }
    }
}

/// Transpose of interpolate with value and (if Gradient) gradient: nodal = sum_q basis * in[0] + grad basis . in[1..].
template <bool Gradient, class S, int P, int Q, int QL>
KOKKOS_FORCEINLINE_FUNCTION void integrate(const S (*in)[Q * QL], const AxisBasis<S, P, Q>& x,
                                           const AxisBasis<RealOf<S>, P, QL>& y, S (&nodal)[power(P + 1, 2)]) {
  for (int j = 0; j <= P; ++j) {
    S sum[P + 1];
    for (int i = 0; i <= P; ++i) sum[i] = S(0.0);
    for (int qx = 0; qx < Q; ++qx) {
      S v = y.value[0][j] * in[0][qx];
      for (int qy = 1; qy < QL; ++qy) v = v + y.value[qy][j] * in[0][qy * Q + qx];
      if constexpr (Gradient) {
        S dx = y.value[0][j] * in[1][qx];
        v = v + y.slope[0][j] * in[2][qx];
        for (int qy = 1; qy < QL; ++qy) {
          dx = dx + y.value[qy][j] * in[1][qy * Q + qx];
          v = v + y.slope[qy][j] * in[2][qy * Q + qx];
        }
        for (int i = 0; i <= P; ++i) sum[i] = sum[i] + x.slope[qx][i] * dx;
      }
      for (int i = 0; i <= P; ++i) sum[i] = sum[i] + x.value[qx][i] * v;
    }
    for (int i = 0; i <= P; ++i) nodal[j * (P + 1) + i] = sum[i];
  }
}

template <bool Gradient, class S, int P, int Q, int QL>
KOKKOS_FORCEINLINE_FUNCTION void integrate(const S (*in)[Q * Q * QL], const AxisBasis<S, P, Q>& x,
                                           const AxisBasis<RealOf<S>, P, Q>& y, const AxisBasis<RealOf<S>, P, QL>& z,
                                           S (&nodal)[power(P + 1, 3)]) {
  constexpr int n = P + 1;
  for (int k = 0; k < n; ++k) {
    S plane[3][Q * Q];
    for (int q = 0; q < Q * Q; ++q) {
      S v = z.value[0][k] * in[0][q];
      for (int qz = 1; qz < QL; ++qz) v = v + z.value[qz][k] * in[0][qz * Q * Q + q];
      if constexpr (Gradient) {
        S dx = z.value[0][k] * in[1][q], dy = z.value[0][k] * in[2][q];
        v = v + z.slope[0][k] * in[3][q];
        for (int qz = 1; qz < QL; ++qz) {
          dx = dx + z.value[qz][k] * in[1][qz * Q * Q + q];
          dy = dy + z.value[qz][k] * in[2][qz * Q * Q + q];
          v = v + z.slope[qz][k] * in[3][qz * Q * Q + q];
        }
        plane[1][q] = dx;
        plane[2][q] = dy;
      }
      plane[0][q] = v;
    }
    S layer[n * n];
    integrate<Gradient, S, P, Q, Q>(plane, x, y, layer);
    for (int a = 0; a < n * n; ++a) nodal[k * n * n + a] = layer[a];
  }
}

}  // namespace softwet
