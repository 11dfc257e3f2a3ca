// A value with its first derivatives along M directions, for exact derivatives of exact solutions (host only). Jets
// nest: Jet<Jet<double, M>, M> carries second derivatives.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

namespace softwet::mms {

/// value + sum_i slope_i d_i,  d_i d_j = 0.  N is double or a jet.
template <class N, int M>
struct Jet {
  N value{};
  std::array<N, M> slope{};

  constexpr Jet() = default;
  constexpr Jet(double v) : value(v) {}
  constexpr Jet(const N& v) requires(!std::is_same_v<N, double>) : value(v) {}

  /// a's value and slopes carried through a function of one argument with this value and slope.
  static constexpr Jet chain(const N& value, const N& derivative, const Jet& a) {
    Jet r(value);
    for (int i = 0; i < M; ++i) r.slope[i] = derivative * a.slope[i];
    return r;
  }

  friend constexpr Jet operator+(const Jet& a, const Jet& b) {
    Jet r(a.value + b.value);
    for (int i = 0; i < M; ++i) r.slope[i] = a.slope[i] + b.slope[i];
    return r;
  }
  friend constexpr Jet operator-(const Jet& a) {
    Jet r(-a.value);
    for (int i = 0; i < M; ++i) r.slope[i] = -a.slope[i];
    return r;
  }
  friend constexpr Jet operator-(const Jet& a, const Jet& b) { return a + (-b); }
  friend constexpr Jet operator*(const Jet& a, const Jet& b) {
    Jet r(a.value * b.value);
    for (int i = 0; i < M; ++i) r.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
    return r;
  }
  friend constexpr Jet operator/(const Jet& a, const Jet& b) {
    const N inverse = 1.0 / b.value, quotient = a.value * inverse;
    Jet r(quotient);
    for (int i = 0; i < M; ++i) r.slope[i] = (a.slope[i] - quotient * b.slope[i]) * inverse;
    return r;
  }
  friend constexpr Jet operator+(const Jet& a, double b) {
    Jet r = a;
    r.value = r.value + b;
    return r;
  }
  friend constexpr Jet operator*(const Jet& a, double b) { return chain(a.value * b, N(b), a); }
  friend constexpr Jet operator+(double a, const Jet& b) { return b + a; }
  friend constexpr Jet operator-(const Jet& a, double b) { return a + (-b); }
  friend constexpr Jet operator-(double a, const Jet& b) { return -b + a; }
  friend constexpr Jet operator*(double a, const Jet& b) { return b * a; }
  friend constexpr Jet operator/(const Jet& a, double b) { return a * (1.0 / b); }
  friend constexpr Jet operator/(double a, const Jet& b) { return Jet(a) / b; }

  friend Jet sin(const Jet& a) {
    using std::cos, std::sin;
    return chain(sin(a.value), cos(a.value), a);
  }
  friend Jet cos(const Jet& a) {
    using std::cos, std::sin;
    return chain(cos(a.value), -sin(a.value), a);
  }
  friend Jet log(const Jet& a) {
    using std::log;
    return chain(log(a.value), 1.0 / a.value, a);
  }
};

}  // namespace softwet::mms
