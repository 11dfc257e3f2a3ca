// Dual numbers: a value and its tangent. Running a point function on them gives the exact Jacobian-vector product.
#pragma once

#include "kernels/algebra/pack.hpp"

namespace softwet {

/// value + tangent * d,  d^2 = 0.  S is a scalar or a pack.
template <class S>
struct Dual {
  S value;
  S tangent;

  Dual() = default;  // without values: zeros would be written for whole bundles at every point
  KOKKOS_FORCEINLINE_FUNCTION Dual(const S& v, const S& t) : value(v), tangent(t) {}
  KOKKOS_FORCEINLINE_FUNCTION Dual(double v) : value(v), tangent(0.0) {}

  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.tangent + b.tangent};
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.tangent - b.tangent};
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator-(const Dual& a) { return {-a.value, -a.tangent}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.tangent * b.value + a.value * b.tangent};
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator/(const Dual& a, const Dual& b) {
    const S inverse = 1.0 / b.value;
    const S quotient = a.value * inverse;
    return {quotient, (a.tangent - quotient * b.tangent) * inverse};
  }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator+(const Dual& a, double b) { return {a.value + b, a.tangent}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator+(double a, const Dual& b) { return {a + b.value, b.tangent}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator-(const Dual& a, double b) { return {a.value - b, a.tangent}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator-(double a, const Dual& b) { return {a - b.value, -b.tangent}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator*(const Dual& a, double b) { return {a.value * b, a.tangent * b}; }
  friend KOKKOS_FORCEINLINE_FUNCTION Dual operator*(double a, const Dual& b) { return {a * b.value, a * b.tangent}; }
  KOKKOS_FORCEINLINE_FUNCTION Dual& operator+=(const Dual& b) { return *this = *this + b; }

  friend KOKKOS_FORCEINLINE_FUNCTION auto operator<(const Dual& a, double b) { return a.value < S(b); }
};

template <class S>
KOKKOS_FORCEINLINE_FUNCTION Dual<S> logarithm(const Dual<S>& x) {
  return {logarithm(x.value), x.tangent / x.value};
}
template <class S>
KOKKOS_FORCEINLINE_FUNCTION Dual<S> square_root(const Dual<S>& x) {
  const S root = square_root(x.value);
  return {root, x.tangent / (root + root)};
}
template <class S>
KOKKOS_FORCEINLINE_FUNCTION Dual<S> real_power(const Dual<S>& x, double exponent) {
  const S power = real_power(x.value, exponent);
  return {power, exponent * power / x.value * x.tangent};
}
/// The derivative by ln(a) is z^4/2, that by ln(b) the opposite.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION Dual<S> half_logarithm_rest(const Dual<S>& a, const Dual<S>& b, const Dual<S>& z) {
  const S square = z.value * z.value;
  return {half_logarithm_rest(a.value, b.value, z.value),
          0.5 * square * square * (a.tangent / a.value - b.tangent / b.value)};
}
template <class Mask, class S>
KOKKOS_FORCEINLINE_FUNCTION Dual<S> select(const Mask& m, const Dual<S>& a, const Dual<S>& b) {
  return {select(m, a.value, b.value), select(m, a.tangent, b.tangent)};
}

/// Scalar or pack underneath a number at a point.
template <class N>
struct Plain {
  using type = N;
};
template <class S>
struct Plain<Dual<S>> {
  using type = S;
};
template <class N>
inline constexpr bool is_dual = !std::is_same_v<typename Plain<N>::type, N>;

/// A number of the kind N that does not move.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N unmoved(const typename Plain<N>::type& x) {
  if constexpr (is_dual<N>) {
    return {x, typename Plain<N>::type(0.0)};
  } else {
    return x;
  }
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N without_tangent(const N& x) {
  if constexpr (is_dual<N>) {
    return unmoved<N>(x.value);
  } else {
    return x;
  }
}

/// The part of a result that is integrated: the tangent of a dual number, the number itself otherwise.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION auto outcome(const N& x) {
  if constexpr (is_dual<N>) {
    return x.tangent;
  } else {
    return x;
  }
}

}  // namespace softwet
