// Numbers at a point: a scalar, a SIMD pack of scalars, or a dual number of either, and the few functions they share.
#pragma once

#include <Kokkos_Core.hpp>
#include <Kokkos_SIMD.hpp>

#include "kernels/algebra/single.hpp"

// Logarithms of glibc's libmvec: all lanes of a pack at once.
#if defined(__GLIBC__) && defined(__AVX512F__) && !defined(__CUDACC__)
#define SOFTWET_VECTOR_LOG
extern "C" [[gnu::const]] __m512d _ZGVeN8v_log(__m512d);
extern "C" [[gnu::const]] __m512 _ZGVeN16v_logf(__m512);
#elif defined(__GLIBC__) && defined(__AVX2__) && !defined(__CUDACC__)
#define SOFTWET_VECTOR_LOG
extern "C" [[gnu::const]] __m256d _ZGVdN4v_log(__m256d);
extern "C" [[gnu::const]] __m256 _ZGVdN8v_logf(__m256);
#endif

namespace softwet {

/// SIMD pack of the widest native width; lanes are consecutive elements.
template <class Real>
using Pack = Kokkos::Experimental::simd<Real>;

/// Number of lanes of a number at a point, and the real numbers in them.
template <class S>
struct Lanes {
  static constexpr int count = 1;
  using Real = S;
};
template <>
struct Lanes<Single> {
  static constexpr int count = 1;
  using Real = float;
};
template <class R, class Abi>
struct Lanes<Kokkos::Experimental::basic_simd<R, Abi>> {
  static constexpr int count = static_cast<int>(Kokkos::Experimental::basic_simd<R, Abi>::size());
  using Real = R;
};
template <class S>
using RealOf = typename Lanes<S>::Real;

/// A pack in single precision with a parameter: Kokkos would widen both to double, except for a parameter on the right
/// of a pack of one lane, which it rounds itself. Packs are numbers of the host: some of their operators do nothing on
/// a device.
template <class Abi>
using SinglePack = Kokkos::Experimental::basic_simd<float, Abi>;
#define SOFTWET_ROUND_PARAMETER(operation)                                                              \
  template <class Abi>                                                                                  \
    requires(!std::is_same_v<Abi, Kokkos::Experimental::simd_abi::scalar>)                              \
  KOKKOS_FORCEINLINE_FUNCTION auto operator operation(const SinglePack<Abi>& a, double b) {             \
    return a operation SinglePack<Abi>(static_cast<float>(b));                                          \
  }                                                                                                     \
  template <class Abi>                                                                                  \
  KOKKOS_FORCEINLINE_FUNCTION auto operator operation(double a, const SinglePack<Abi>& b) {             \
    return SinglePack<Abi>(static_cast<float>(a)) operation b;                                          \
  }                                                                                                     \
  template <class Abi>                                                                                  \
  requires std::is_same_v<Abi, Kokkos::Experimental::simd_abi::scalar> KOKKOS_FORCEINLINE_FUNCTION auto \
  operator operation(float a, const SinglePack<Abi>& b) {                                               \
    return SinglePack<Abi>(a) operation b;                                                              \
  }
SOFTWET_ROUND_PARAMETER(+)
SOFTWET_ROUND_PARAMETER(-)
SOFTWET_ROUND_PARAMETER(*)
SOFTWET_ROUND_PARAMETER(/)
SOFTWET_ROUND_PARAMETER(<)
#undef SOFTWET_ROUND_PARAMETER

/// Scalar versions; packs get theirs below.
KOKKOS_FORCEINLINE_FUNCTION double logarithm(double x) { return Kokkos::log(x); }
KOKKOS_FORCEINLINE_FUNCTION float logarithm(float x) { return Kokkos::log(x); }
KOKKOS_FORCEINLINE_FUNCTION double square_root(double x) { return Kokkos::sqrt(x); }
KOKKOS_FORCEINLINE_FUNCTION float square_root(float x) { return Kokkos::sqrt(x); }
KOKKOS_FORCEINLINE_FUNCTION double select(bool m, double a, double b) { return m ? a : b; }
KOKKOS_FORCEINLINE_FUNCTION float select(bool m, float a, float b) { return m ? a : b; }

template <class Real, class Abi>
KOKKOS_FORCEINLINE_FUNCTION auto square_root(const Kokkos::Experimental::basic_simd<Real, Abi>& x) {
  return Kokkos::sqrt(x);
}
template <class Mask, class Real, class Abi>
KOKKOS_FORCEINLINE_FUNCTION auto select(const Mask& m, const Kokkos::Experimental::basic_simd<Real, Abi>& a,
                                        const Kokkos::Experimental::basic_simd<Real, Abi>& b) {
  return Kokkos::Experimental::condition(m, a, b);
}
/// Lane by lane, except where the C library has a vector version (glibc's libmvec, within 4 units in the last place).
template <class Real, class Abi>
KOKKOS_FORCEINLINE_FUNCTION auto logarithm(const Kokkos::Experimental::basic_simd<Real, Abi>& x) {
  using P = Kokkos::Experimental::basic_simd<Real, Abi>;
#ifdef SOFTWET_VECTOR_LOG
#ifdef __AVX512F__
  if constexpr (std::is_same_v<Real, double> && P::size() == 8) return P(_ZGVeN8v_log(static_cast<__m512d>(x)));
  if constexpr (std::is_same_v<Real, float> && P::size() == 16) return P(_ZGVeN16v_logf(static_cast<__m512>(x)));
#else
  if constexpr (std::is_same_v<Real, double> && P::size() == 4) return P(_ZGVdN4v_log(static_cast<__m256d>(x)));
  if constexpr (std::is_same_v<Real, float> && P::size() == 8) return P(_ZGVdN8v_logf(static_cast<__m256>(x)));
#endif
#endif
  Real lane[P::size()];
  Kokkos::Experimental::simd_unchecked_store(x, lane, Kokkos::Experimental::simd_flag_default);
  for (std::size_t l = 0; l < P::size(); ++l) lane[l] = Kokkos::log(lane[l]);
  return Kokkos::Experimental::simd_unchecked_load<P>(lane, Kokkos::Experimental::simd_flag_default);
}

template <class N>
KOKKOS_FORCEINLINE_FUNCTION N arsinh(const N& x) {
  const auto negative = x < 0.0;
  const N size = select(negative, N(0.0 - x), x);
  const N y = logarithm(size + square_root(size * size + 1.0));
  return select(negative, N(0.0 - y), y);
}

/// ln(a/b)/2 - z - z^3/3 for positive numbers a and b and z = (a - b)/(a + b): of fifth order in z. No digits are lost
/// where a and b are close: there it is the series of artanh(z) without its first two terms.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION S half_logarithm_rest(const S& a, const S& b, const S& z) {
  const S square = z * z;
  S series = S(0.0);
  for (int k = 23; k >= 0; --k) series = series * square + 1.0 / (2 * k + 5);
  const S whole = 0.5 * logarithm(a / b) - z * (1.0 + (1.0 / 3.0) * square);
  return select(square < 0.25, S(z * square * square * series), whole);
}

/// A number that is not a pack.
template <class S>
inline constexpr bool is_one_number = std::is_arithmetic_v<S> || std::is_same_v<S, Single>;

/// Whether any lane is not zero.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION bool any_nonzero(const S& x) {
  if constexpr (is_one_number<S>) {
    return plain(x) != 0;
  } else {
    return Kokkos::Experimental::any_of(x != S(0));
  }
}

/// Reads lanes p[0], p[1], ... (consecutive elements).
template <class S, class Real>
KOKKOS_FORCEINLINE_FUNCTION S load(const Real* p) {
  if constexpr (is_one_number<S>) {
    return S(*p);
  } else {
    return Kokkos::Experimental::simd_unchecked_load<S>(p, Kokkos::Experimental::simd_flag_default);
  }
}

/// x to the power of a number that is not an integer, x > 0.
KOKKOS_FORCEINLINE_FUNCTION double real_power(double x, double exponent) { return Kokkos::pow(x, exponent); }
KOKKOS_FORCEINLINE_FUNCTION float real_power(float x, double exponent) {
  return Kokkos::pow(x, static_cast<float>(exponent));
}
template <class Real, class Abi>
KOKKOS_FORCEINLINE_FUNCTION auto real_power(const Kokkos::Experimental::basic_simd<Real, Abi>& x, double exponent) {
  using P = Kokkos::Experimental::basic_simd<Real, Abi>;
  Real lane[P::size()];
  Kokkos::Experimental::simd_unchecked_store(x, lane, Kokkos::Experimental::simd_flag_default);
  for (std::size_t l = 0; l < P::size(); ++l) lane[l] = Kokkos::pow(lane[l], static_cast<Real>(exponent));
  return load<P>(lane);
}

/// Adds lanes to p[0], p[1], ...
template <class S, class Real>
KOKKOS_FORCEINLINE_FUNCTION void add_to(Real* p, const S& x) {
  if constexpr (is_one_number<S>) {
    *p += plain(x);
  } else {
    Kokkos::Experimental::simd_unchecked_store(load<S>(p) + x, p, Kokkos::Experimental::simd_flag_default);
  }
}

}  // namespace softwet
