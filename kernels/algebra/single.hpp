// One number in single precision, for a device. Parameters of terms are doubles, and a plain float combined with one
// would be computed as a double: `Single` rounds them, as packs do on the host.
#pragma once

#include <Kokkos_Core.hpp>

namespace softwet {

struct Single {
  float value;

  Single() = default;
  KOKKOS_FORCEINLINE_FUNCTION explicit Single(float x) : value(x) {}
  KOKKOS_FORCEINLINE_FUNCTION explicit Single(double x) : value(static_cast<float>(x)) {}

  KOKKOS_FORCEINLINE_FUNCTION Single operator-() const { return Single(-value); }
  KOKKOS_FORCEINLINE_FUNCTION Single& operator+=(const Single& b) {
    value += b.value;
    return *this;
  }
};

#define SOFTWET_SINGLE(operation)                                                         \
  KOKKOS_FORCEINLINE_FUNCTION auto operator operation(const Single& a, const Single& b) { \
    return as_single(a.value operation b.value);                                          \
  }                                                                                       \
  KOKKOS_FORCEINLINE_FUNCTION auto operator operation(const Single& a, double b) {        \
    return as_single(a.value operation static_cast<float>(b));                            \
  }                                                                                       \
  KOKKOS_FORCEINLINE_FUNCTION auto operator operation(double a, const Single& b) {        \
    return as_single(static_cast<float>(a) operation b.value);                            \
  }
/// Results of arithmetic are Single; results of comparisons remain bool.
KOKKOS_FORCEINLINE_FUNCTION Single as_single(float x) { return Single(x); }
KOKKOS_FORCEINLINE_FUNCTION bool as_single(bool x) { return x; }
SOFTWET_SINGLE(+)
SOFTWET_SINGLE(-)
SOFTWET_SINGLE(*)
SOFTWET_SINGLE(/)
SOFTWET_SINGLE(<)
#undef SOFTWET_SINGLE

KOKKOS_FORCEINLINE_FUNCTION Single logarithm(const Single& x) { return Single(Kokkos::log(x.value)); }
KOKKOS_FORCEINLINE_FUNCTION Single real_power(const Single& x, double exponent) {
  return Single(Kokkos::pow(x.value, static_cast<float>(exponent)));
}
KOKKOS_FORCEINLINE_FUNCTION Single square_root(const Single& x) { return Single(Kokkos::sqrt(x.value)); }
KOKKOS_FORCEINLINE_FUNCTION Single select(bool m, const Single& a, const Single& b) { return m ? a : b; }

/// The number itself, of one that has one lane.
KOKKOS_FORCEINLINE_FUNCTION double plain(double x) { return x; }
KOKKOS_FORCEINLINE_FUNCTION float plain(float x) { return x; }
KOKKOS_FORCEINLINE_FUNCTION float plain(const Single& x) { return x.value; }

/// What a thread of a device computes with, one element or one point each.
template <class Real>
using OneNumber = std::conditional_t<std::is_same_v<Real, float>, Single, Real>;

}  // namespace softwet
