// What the Jacobian of a term sees at a point, and where the entries of an element's matrix go.
#pragma once

#include "field/stencil.hpp"
#include "operator/batch.hpp"
#include "operator/rows.hpp"

namespace softwet {

/// Geometry at a point that does not depend on the unknowns, for numbers with a tangent: it acts on value and tangent.
template <class N, int D, class Point>
struct FrozenPoint {
  using S = typename Plain<N>::type;
  const Point& point;
  Vector<N, D> normal;

  KOKKOS_FORCEINLINE_FUNCTION explicit FrozenPoint(const Point& frozen) : point(frozen) {
    if constexpr (requires { frozen.normal; }) normal = fixed(frozen.normal);
  }

  static KOKKOS_FORCEINLINE_FUNCTION void split(const Vector<N, D>& g, Vector<S, D>& value, Vector<S, D>& tangent) {
    for (int i = 0; i < D; ++i) {
      value[i] = g[i].value;
      tangent[i] = g[i].tangent;
    }
  }
  static KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> fixed(const Vector<S, D>& value) {
    Vector<N, D> g;
    for (int i = 0; i < D; ++i) g[i] = N(value[i], S(0.0));
    return g;
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> physical(const Vector<N, D>& g) const {
    Vector<S, D> value, tangent;
    split(g, value, tangent);
    return join(point.physical(value), point.physical(tangent));
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> reference_flux(const Vector<N, D>& f) const {
    Vector<S, D> value, tangent;
    split(f, value, tangent);
    return join(point.reference_flux(value), point.reference_flux(tangent));
  }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x) const {
    return N(point.measured(x.value), point.measured(x.tangent));
  }
  KOKKOS_FORCEINLINE_FUNCTION N measured(const N& x, const N& hoop) const {
    return N(point.measured(x.value, hoop.value), point.measured(x.tangent, hoop.tangent));
  }
  KOKKOS_FORCEINLINE_FUNCTION bool remembers() const { return point.remembers(); }
  KOKKOS_FORCEINLINE_FUNCTION S remembered(int k) const { return point.remembered(k); }
  KOKKOS_FORCEINLINE_FUNCTION N radius() const { return N(point.radius(), S(0.0)); }
  KOKKOS_FORCEINLINE_FUNCTION N area_ratio() const { return N(point.area_ratio(), S(0.0)); }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return fixed(point.mesh_velocity()); }
};

/// Slots of a batch whose tangent is the derivative by one reference derivative (0: value) of one unknown.
template <class Fields, class N, class Trial, int D>
struct SeededFields {
  const Fields& fields;
  int unknown, derivative;

  KOKKOS_FORCEINLINE_FUNCTION N number(int s, int c, int q) const {
    const bool here = Trial::slot(s).from.unknown(D) == unknown && c == derivative;
    using S = std::remove_cvref_t<decltype(fields.value[0][0][0])>;
    return N(fields.value[s][c][q], S(here ? fields.scale[s] : 0.0));
  }
};

/// Where an entry of an element's matrix is stored, for a pair of components. Entries are numbered by pairs of
/// functions, with the function of the first axis slowest; `first` is the control point of the element's first
/// function.
template <int D, int P>
KOKKOS_FORCEINLINE_FUNCTION std::int64_t place_of_entry(const Stencil<D>& stencil, int row, int column, int first,
                                                        int entry) {
  constexpr int n = P + 1;
  int rest = entry, point = first, offset = 0;
  for (int d = D - 1, pair = 0; d >= 0; --d) {
    pair = rest % (n * n);
    rest /= n * n;
    const int i = pair / n, j = pair % n;
    int stride = 1;
    for (int below = 0; below < d; ++below) stride *= stencil.extent[below];
    point += i * stride;
    offset = offset * (2 * P + 1) + j - i + P;
  }
  return stencil.index(row, column, offset, point);
}

}  // namespace softwet
