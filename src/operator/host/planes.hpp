// Planes of a column on the host: fields on one layer of control values, swept along all axes but the last.
#pragma once

#include "operator/task.hpp"

namespace softwet {

/// Points of a plane, and what it holds at each: value, then slopes along all axes but the last.
template <class S, int D, int Q>
using Plane = S[D][power(Q, D - 1)];

/// The bases that all elements of a column share.
template <class S, int D, int P, int Q>
struct PlaneBasis {
  using Real = RealOf<S>;
  static constexpr int controls = power(P + 1, D - 1), points = power(Q, D - 1);
  AxisBasis<S, P, Q> x;
  AxisBasis<Real, P, Q> y;  // 3D only
  S weight[points];

  PlaneBasis(const Region<D, Real>& region, const Batch<D>& b) : x(load_basis<S, P, Q>(region.axis[0], b.element[0])) {
    if constexpr (D == 3) y = load_basis<Real, P, Q>(region.axis[1], b.element[1]);
    for (int w = 0; w < points; ++w) {
      weight[w] = load<S>(&region.axis[0].weight(w % Q, b.element[0]));
      if constexpr (D == 3) weight[w] = weight[w] * region.axis[1].weight(w / Q, b.element[1]);
    }
  }

  template <bool Slopes>
  KOKKOS_FORCEINLINE_FUNCTION void forward(const S (&nodal)[controls], Plane<S, D, Q>& out) const {
    if constexpr (D == 3) {
      interpolate<true, Slopes, S, P, Q, Q>(nodal, x, y, out);
    } else {
      for (int q = 0; q < Q; ++q) {
        S value = x.value[q][0] * nodal[0], slope = x.slope[q][0] * nodal[0];
        for (int i = 1; i <= P; ++i) {
          value = value + x.value[q][i] * nodal[i];
          if constexpr (Slopes) slope = slope + x.slope[q][i] * nodal[i];
        }
        out[0][q] = value;
        if constexpr (Slopes) out[1][q] = slope;
      }
    }
  }

  template <bool Slopes>
  KOKKOS_FORCEINLINE_FUNCTION void backward(const Plane<S, D, Q>& in, S (&nodal)[controls]) const {
    if constexpr (D == 3) {
      integrate<Slopes, S, P, Q, Q>(in, x, y, nodal);
    } else {
      for (int i = 0; i <= P; ++i) {
        S sum = x.value[0][i] * in[0][0];
        if constexpr (Slopes) sum = sum + x.slope[0][i] * in[1][0];
        for (int q = 1; q < Q; ++q) {
          sum = sum + x.value[q][i] * in[0][q];
          if constexpr (Slopes) sum = sum + x.slope[q][i] * in[1][q];
        }
        nodal[i] = sum;
      }
    }
  }
};

/// The basis of an element along the last axis, and where a ring keeps the planes of its layers.
template <class Real, int P, int Q>
struct ElementLayers : AxisBasis<Real, P, Q> {
  int place[P + 1];

  ElementLayers(const AxisRuleOf<Real>& rule, int element)
      : AxisBasis<Real, P, Q>(load_basis<Real, P, Q>(rule, element)) {
    for (int k = 0; k <= P; ++k) place[k] = (rule.first(element) + k) % (P + 1);
  }
};

/// The planes of one field around an element: the plane of layer k is at k % (degree + 1).
template <class S, int D, int P, int Q>
struct PlaneRing {
  Plane<S, D, Q> plane[P + 1];

  KOKKOS_FORCEINLINE_FUNCTION Plane<S, D, Q>& of(int layer) { return plane[layer % (P + 1)]; }

  /// Value and gradient at the points above point w of the plane.
  template <bool Value, bool Gradient>
  KOKKOS_FORCEINLINE_FUNCTION void interpolate_line(const ElementLayers<RealOf<S>, P, Q>& last, int w,
                                                    S (&out)[1 + D][Q]) const {
    S layer[D][P + 1];
    for (int k = 0; k <= P; ++k)
      for (int c = 0; c < (Gradient ? D : 1); ++c) layer[c][k] = plane[last.place[k]][c][w];
    for (int q = 0; q < Q; ++q) {
      if constexpr (Value) out[0][q] = along(last.value[q], layer[0]);
      if constexpr (Gradient) {
        for (int d = 1; d < D; ++d) out[d][q] = along(last.value[q], layer[d]);
        out[D][q] = along(last.slope[q], layer[0]);
      }
    }
  }

  /// Transpose: adds the integrals of the points above point w.
  template <bool Flux>
  KOKKOS_FORCEINLINE_FUNCTION void integrate_line(const ElementLayers<RealOf<S>, P, Q>& last, int w,
                                                  const S (&in)[1 + D][Q]) {
    for (int k = 0; k <= P; ++k) {
      Plane<S, D, Q>& to = plane[last.place[k]];
      S value = to[0][w];
      for (int q = 0; q < Q; ++q) {
        value = value + last.value[q][k] * in[0][q];
        if constexpr (Flux) value = value + last.slope[q][k] * in[D][q];
      }
      to[0][w] = value;
      for (int d = 1; d < D && Flux; ++d) {
        S slope = to[d][w];
        for (int q = 0; q < Q; ++q) slope = slope + last.value[q][k] * in[d][q];
        to[d][w] = slope;
      }
    }
  }

  static KOKKOS_FORCEINLINE_FUNCTION S along(const RealOf<S> (&basis)[P + 1], const S (&layer)[P + 1]) {
    S sum = basis[0] * layer[0];
    for (int k = 1; k <= P; ++k) sum = sum + basis[k] * layer[k];
    return sum;
  }
};

/// The control values that a plane is made of, of one layer of a component.
template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void gather_layer(const RealOf<S>* p, const Region<D, RealOf<S>>& region, int count,
                                              S (&nodal)[power(P + 1, D - 1)]) {
  for (int a = 0; a < power(P + 1, D - 1); ++a)
    nodal[a] = load_lanes<S>(p + a % (P + 1) + (D == 3 ? a / (P + 1) * region.stride[1] : 0), count);
}

/// Adds a layer of control values for all channels. Packs of neighbouring i overlap in memory: with i outermost a pack
/// is stored long before its lanes are read again.
template <class S, int D, int P, int channels>
KOKKOS_FORCEINLINE_FUNCTION void scatter_layer(RealOf<S>* const (&test)[channels], const Region<D, RealOf<S>>& region,
                                               int first, int count, const S (&nodal)[channels][power(P + 1, D - 1)]) {
  for (int i = 0; i <= P; ++i)
    for (int c = 0; c < channels; ++c)
      for (int j = 0; j < (D == 3 ? P + 1 : 1); ++j)
        add_lanes(test[c] + first + i + (D == 3 ? j * region.stride[1] : 0), nodal[c][j * (P + 1) + i], count);
}

}  // namespace softwet
