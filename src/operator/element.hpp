// One batch of elements: control values -> fields at points -> reader for a term -> integrals back to control values.
#pragma once

#include "kernels/basis/contract.hpp"
#include "kernels/point/fields.hpp"
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

/// Offset of the first test function of a batch in a component.
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

}  // namespace softwet
