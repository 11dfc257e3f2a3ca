// Numbers that know their derivatives by several others, and the derivative of an energy by the entries of a matrix.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// A value and its derivatives by `count` numbers. N is a number at a point; where it is a dual number, the derivatives have
/// tangents, which are the second derivatives that a Jacobian-vector product needs.
template <class N, int count>
struct Gradient {
  N value;
  N by[count];

  Gradient() = default;
  KOKKOS_FORCEINLINE_FUNCTION Gradient(double v) : Gradient(N(v)) {}
  KOKKOS_FORCEINLINE_FUNCTION explicit Gradient(const N& v) : value(v) {
    for (int k = 0; k < count; ++k) by[k] = N(0.0);
  }
  /// The derivative by number k is 1.
  static KOKKOS_FORCEINLINE_FUNCTION Gradient variable(const N& v, int k) {
    Gradient r(v);
    r.by[k] = N(1.0);
    return r;
  }
  /// f of a with the slope df/da.
  static KOKKOS_FORCEINLINE_FUNCTION Gradient chain(const N& f, const N& slope, const Gradient& a) {
    Gradient r;
    r.value = f;
    for (int k = 0; k < count; ++k) r.by[k] = slope * a.by[k];
    return r;
  }

  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator+(const Gradient& a, const Gradient& b) {
    Gradient r;
    r.value = a.value + b.value;
    for (int k = 0; k < count; ++k) r.by[k] = a.by[k] + b.by[k];
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator-(const Gradient& a, const Gradient& b) {
    Gradient r;
    r.value = a.value - b.value;
    for (int k = 0; k < count; ++k) r.by[k] = a.by[k] - b.by[k];
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator-(const Gradient& a) {
    Gradient r;
    r.value = -a.value;
    for (int k = 0; k < count; ++k) r.by[k] = -a.by[k];
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator*(const Gradient& a, const Gradient& b) {
    Gradient r;
    r.value = a.value * b.value;
    for (int k = 0; k < count; ++k) r.by[k] = a.by[k] * b.value + a.value * b.by[k];
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator/(const Gradient& a, const Gradient& b) {
    const N inverse = 1.0 / b.value;
    Gradient r;
    r.value = a.value * inverse;
    for (int k = 0; k < count; ++k) r.by[k] = (a.by[k] - r.value * b.by[k]) * inverse;
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator+(Gradient a, double b) {
    a.value = a.value + b;
    return a;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator+(double a, const Gradient& b) { return b + a; }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator-(const Gradient& a, double b) { return a + (-b); }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator-(double a, const Gradient& b) { return -b + a; }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator*(double a, const Gradient& b) {
    Gradient r;
    r.value = a * b.value;
    for (int k = 0; k < count; ++k) r.by[k] = a * b.by[k];
    return r;
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator*(const Gradient& a, double b) { return b * a; }
  friend KOKKOS_FORCEINLINE_FUNCTION Gradient operator/(const Gradient& a, double b) { return (1 / b) * a; }
  friend KOKKOS_FORCEINLINE_FUNCTION auto operator<(const Gradient& a, double b) { return a.value < b; }
};

template <class N, int count>
KOKKOS_FORCEINLINE_FUNCTION Gradient<N, count> logarithm(const Gradient<N, count>& x) {
  return Gradient<N, count>::chain(logarithm(x.value), 1.0 / x.value, x);
}
template <class N, int count>
KOKKOS_FORCEINLINE_FUNCTION Gradient<N, count> square_root(const Gradient<N, count>& x) {
  const N root = square_root(x.value);
  return Gradient<N, count>::chain(root, 0.5 / root, x);
}
template <class Mask, class N, int count>
KOKKOS_FORCEINLINE_FUNCTION Gradient<N, count> select(const Mask& m, const Gradient<N, count>& a,
                                                      const Gradient<N, count>& b) {
  Gradient<N, count> r;
  r.value = select(m, a.value, b.value);
  for (int k = 0; k < count; ++k) r.by[k] = select(m, a.by[k], b.by[k]);
  return r;
}

/// How a law finds its stress from its energy: by one entry of the gradient after another, or by all at once.
enum class Way { by_entry, at_once };

/// d energy / d g by the entries of the first `columns` columns of g; the others are zero.
/// @param energy  a function of matrices of numbers of any type
template <Way way, int columns, class N, int D, class Energy>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> derivative(const Matrix<N, D>& g, const Energy& energy) {
  constexpr int count = way == Way::at_once ? D * columns : 1;
  using G = Gradient<N, count>;
  Matrix<N, D> r;
  Matrix<G, D> x;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      r(i, j) = N(0.0);
      x(i, j) = count > 1 && j < columns ? G::variable(g(i, j), i * columns + j) : G(g(i, j));
    }
  if constexpr (way == Way::at_once) {
    const G e = energy(x);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < columns; ++j) r(i, j) = e.by[i * columns + j];
  } else {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < columns; ++j) {
        Matrix<G, D> moved = x;
        moved(i, j) = G::variable(g(i, j), 0);
        r(i, j) = energy(moved).by[0];
      }
  }
  return r;
}

}  // namespace softwet
