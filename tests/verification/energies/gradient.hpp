// Numbers that know their derivatives by several others, and the derivative of an energy by the entries of a matrix.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// A value and its derivatives by `count` numbers. N is a number at a point; where it is a dual number, the derivatives
/// have tangents, which are the second derivatives that a Jacobian-vector product needs.
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

/// How a law finds its stress from its energy: by one entry of the gradient after another, with dual numbers of its
/// numbers, or by all entries at once.
enum class Way { by_entry, at_once };

/// d energy / d g by the entries of the first `columns` columns of g; the others are zero.
/// @param energy  a function of matrices of numbers of any type
template <Way way, int columns, class N, int D, class Energy>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> derivative(const Matrix<N, D>& g, const Energy& energy) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = columns; j < D; ++j) r(i, j) = N(0.0);
  if constexpr (way == Way::at_once) {
    using G = Gradient<N, D * columns>;
    Matrix<G, D> x;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) x(i, j) = j < columns ? G::variable(g(i, j), i * columns + j) : G(g(i, j));
    const G e = energy(x);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < columns; ++j) r(i, j) = e.by[i * columns + j];
  } else {
    // Entries are constants of the compiler: loops over them would leave the numbers in memory, at twice the time.
    const auto by = [&]<int entry>(std::integral_constant<int, entry>) {
      Matrix<Dual<N>, D> x;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) x(i, j) = Dual<N>(g(i, j), N(i * columns + j == entry && j < columns ? 1.0 : 0.0));
      r(entry / columns, entry % columns) = energy(x).tangent;
    };
    [&]<int... entry>(std::integer_sequence<int, entry...>) { (by(std::integral_constant<int, entry>()), ...); }
    (std::make_integer_sequence<int, D * columns>());
  }
  return r;
}

}  // namespace softwet
