// What instructions compute of the numbers of one lane: a type with a function `of` for each operation.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace emulate {

// NOLINTBEGIN: one line an operation
#define UNARY(Name, expression) \
  struct Name {                 \
    template <class T>          \
    static auto of(T a) {       \
      return expression;        \
    }                           \
  };
#define BINARY(Name, expression)    \
  struct Name {                     \
    template <class T, class B = T> \
    static auto of(T a, B b) {      \
      return expression;            \
    }                               \
  };
#define TERNARY(Name, expression)                \
  struct Name {                                  \
    template <class T, class B = T, class C = T> \
    static auto of(T a, B b, C c) {              \
      return expression;                         \
    }                                            \
  };
// NOLINTEND

template <class T>
using Wide = std::conditional_t<std::is_signed_v<T>, std::conditional_t<sizeof(T) == 2, std::int32_t, std::int64_t>,
                                std::conditional_t<sizeof(T) == 2, std::uint32_t, std::uint64_t>>;
template <class T>
using Unsigned = std::make_unsigned_t<T>;

template <class T>
T high(T a, T b) {
  if constexpr (sizeof(T) == 8) {
    if constexpr (std::is_signed_v<T>)
      return static_cast<T>((static_cast<__int128>(a) * b) >> 64);
    else
      return static_cast<T>((static_cast<unsigned __int128>(a) * b) >> 64);
  } else {
    return static_cast<T>((static_cast<Wide<T>>(a) * static_cast<Wide<T>>(b)) >> (8 * sizeof(T)));
  }
}
template <class T>
T least(T a, T b) {
  if constexpr (std::is_floating_point_v<T>)
    return a < b ? a : b < a ? b : a != a ? b : b != b ? a : std::signbit(a) ? a : b;
  else
    return a < b ? a : b;
}
template <class T>
T most(T a, T b) {
  if constexpr (std::is_floating_point_v<T>)
    return a > b ? a : b > a ? b : a != a ? b : b != b ? a : std::signbit(a) ? b : a;
  else
    return a > b ? a : b;
}
template <class T>
T bit_field(T a, std::uint32_t begin, std::uint32_t length) {
  const int bits = 8 * sizeof(T);
  begin &= 255, length &= 255;
  if constexpr (std::is_signed_v<T>) {
    const int top = static_cast<int>(std::min<std::uint32_t>(begin + length - 1, bits - 1));
    const Unsigned<T> sign = length == 0 ? 0 : (static_cast<Unsigned<T>>(a) >> top) & 1;
    Unsigned<T> d = begin < static_cast<unsigned>(bits) ? static_cast<Unsigned<T>>(a) >> begin : 0;
    int have = begin < static_cast<unsigned>(bits) ? std::min<int>(length, bits - static_cast<int>(begin)) : 0;
    if (have < bits) {
      const Unsigned<T> m = (static_cast<Unsigned<T>>(1) << have) - 1;
      d = (d & m) | (sign ? ~m : 0);
    }
    return static_cast<T>(d);
  } else {
    if (begin >= static_cast<unsigned>(bits) || length == 0) return 0;
    const T d = a >> begin;
    return length >= static_cast<unsigned>(bits) ? d : static_cast<T>(d & ((static_cast<T>(1) << length) - 1));
  }
}
template <class T>
T sat01(T x) {
  return x > 0 ? (x < 1 ? x : T(1)) : T(0);
}
inline std::uint32_t permuted(std::uint32_t a, std::uint32_t b, std::uint32_t selector) {
  const std::uint64_t all = a | static_cast<std::uint64_t>(b) << 32;
  std::uint32_t d = 0;
  for (int k = 0; k < 4; ++k) {
    const std::uint32_t s = selector >> (4 * k) & 15;
    std::uint32_t byte = static_cast<std::uint32_t>(all >> (8 * (s & 7))) & 255;
    if (s & 8) byte = byte & 128 ? 255 : 0;
    d |= byte << (8 * k);
  }
  return d;
}
inline std::uint32_t reversed(std::uint32_t x) {
  std::uint32_t d = 0;
  for (int k = 0; k < 32; ++k) d |= (x >> k & 1) << (31 - k);
  return d;
}

UNARY(Move, a)
UNARY(Negate, T(-a))
UNARY(Absolute, T(a < 0 ? -a : a))
UNARY(AbsoluteF, std::fabs(a))
UNARY(Not, T(~a))
UNARY(CNot, T(a == 0))
UNARY(Root, std::sqrt(a))
UNARY(Reciprocal, T(1) / a)
UNARY(ReciprocalRoot, T(1) / std::sqrt(a))
UNARY(Exp2, std::exp2(a))
UNARY(Log2, std::log2(a))
UNARY(Sine, std::sin(a))
UNARY(Cosine, std::cos(a))
UNARY(Tanh, std::tanh(a))
UNARY(Population, std::uint32_t(std::popcount(a)))
UNARY(LeadingZeros, std::uint32_t(std::countl_zero(a)))
UNARY(Reverse32, reversed(a))
UNARY(Reverse64, (std::uint64_t(reversed(std::uint32_t(a))) << 32 | reversed(std::uint32_t(a >> 32))))
BINARY(Add, T(a + b))
BINARY(Subtract, T(a - b))
BINARY(Multiply, T(a* b))
BINARY(MultiplyHigh, high(a, T(b)))
BINARY(MultiplyWide, (static_cast<Wide<T>>(a) * static_cast<Wide<T>>(b)))
BINARY(AddSat, sat01(T(a + b)))
BINARY(SubtractSat, sat01(T(a - b)))
BINARY(MultiplySat, sat01(T(a* b)))
BINARY(DivideF, T(a / b))
BINARY(Minimum, least(a, T(b)))
BINARY(Maximum, most(a, T(b)))
BINARY(And, T(a& b))
BINARY(Or, T(a | b))
BINARY(Xor, T(a ^ b))
BINARY(ShiftLeft, T(b >= 8 * sizeof(T) ? 0 : a << (b & (8 * sizeof(T) - 1))))
BINARY(ShiftRight, T(b >= 8 * sizeof(T) ? (a < 0 ? -1 : 0) : a >> (b & (8 * sizeof(T) - 1))))
BINARY(CopySign, std::copysign(T(b), a))
TERNARY(MultiplyAdd, T(a* b + c))
TERNARY(MultiplyAddHigh, T(high(a, T(b)) + c))
TERNARY(MultiplyAddWide, (static_cast<Wide<T>>(a) * static_cast<Wide<T>>(b) + c))
TERNARY(Fused, std::fma(a, b, c))
TERNARY(FusedSat, sat01(std::fma(a, b, c)))
TERNARY(Field, bit_field(a, b, c))
TERNARY(Permute, permuted(a, b, c))
TERNARY(FunnelLeftWrap, T((std::uint64_t(b) << 32 | a) << (c & 31) >> 32))
TERNARY(FunnelRightWrap, T((std::uint64_t(b) << 32 | a) >> (c & 31)))
TERNARY(FunnelLeftClamp, T((std::uint64_t(b) << 32 | a) << (c < 32 ? c : 32) >> 32))
TERNARY(FunnelRightClamp, T((std::uint64_t(b) << 32 | a) >> (c < 32 ? c : 32)))
TERNARY(Sad, T(c + (a < b ? b - a : a - b)))

}  // namespace emulate
