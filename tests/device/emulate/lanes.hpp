// Loops over the 32 lanes of a warp, which the compiler vectorises. Registers of up to 32 bits have 4 bytes a lane, others 8, and
// predicates are one bit a lane.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "machine.hpp"
#include "program.hpp"

namespace emulate {

template <class T>
using Slot = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

template <class T>
inline T value_of(Slot<T> bits) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<T>(bits);
  else
    return static_cast<T>(bits);
}
template <class T>
inline Slot<T> bits_of(T value) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<Slot<T>>(value);
  else
    return static_cast<Slot<T>>(value);
}
template <class S>
inline S* target(Warp& w, std::uint32_t at) {
  return reinterpret_cast<S*>(w.bases[0] + at);
}
template <class S>
inline const S* source(const Warp& w, Place place) {
  return reinterpret_cast<const S*>(w.bases[place.base] + place.at);
}
template <bool Full, class S>
inline void put(S* d, int lane, S bits, std::uint32_t mask) {
  if constexpr (Full) {
    d[lane] = bits;
  } else {
    const S m = -static_cast<S>((mask >> lane) & 1);
    d[lane] = (bits & m) | (d[lane] & ~m);
  }
}

/// 32 truth values of one byte each as bits.
inline std::uint32_t packed(const std::uint8_t* truth) {
  std::uint32_t all = 0;
  for (int k = 0; k < 4; ++k) {
    std::uint64_t x;
    std::memcpy(&x, truth + 8 * k, 8);
    all |= static_cast<std::uint32_t>((x * 0x0102040810204080ull) >> 56) << (8 * k);
  }
  return all;
}
inline std::uint32_t predicate(const Warp& w, Place place) { return *source<std::uint32_t>(w, place); }
inline void put_predicate(Warp& w, std::uint32_t at, std::uint32_t bits, std::uint32_t mask) {
  if (at == nowhere) return;
  auto* d = target<std::uint32_t>(w, at);
  *d = (*d & ~mask) | (bits & mask);
}

struct Handlers {
  Handler full, part;
};

template <class R, class A, class Op, bool Full>
void unary_lanes(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<Slot<R>>(w, i.d);
  const auto* a = source<Slot<A>>(w, i.a);
#pragma GCC ivdep
  for (int l = 0; l < 32; ++l) put<Full>(d, l, bits_of<R>(Op::template of<A>(value_of<A>(a[l]))), mask);
}
template <class R, class A, class B, class Op, bool Full>
void binary_lanes(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<Slot<R>>(w, i.d);
  const auto* a = source<Slot<A>>(w, i.a);
  const auto* b = source<Slot<B>>(w, i.b);
#pragma GCC ivdep
  for (int l = 0; l < 32; ++l)
    put<Full>(d, l, bits_of<R>(Op::template of<A>(value_of<A>(a[l]), value_of<B>(b[l]))), mask);
}
template <class R, class A, class B, class C, class Op, bool Full>
void ternary_lanes(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<Slot<R>>(w, i.d);
  const auto* a = source<Slot<A>>(w, i.a);
  const auto* b = source<Slot<B>>(w, i.b);
  const auto* c = source<Slot<C>>(w, i.c);
#pragma GCC ivdep
  for (int l = 0; l < 32; ++l)
    put<Full>(d, l, bits_of<R>(Op::template of<A>(value_of<A>(a[l]), value_of<B>(b[l]), value_of<C>(c[l]))), mask);
}
template <class R, class A, class Op>
Handlers unary() {
  return {unary_lanes<R, A, Op, true>, unary_lanes<R, A, Op, false>};
}
template <class R, class A, class B, class Op>
Handlers binary() {
  return {binary_lanes<R, A, B, Op, true>, binary_lanes<R, A, B, Op, false>};
}
template <class R, class A, class B, class C, class Op>
Handlers ternary() {
  return {ternary_lanes<R, A, B, C, Op, true>, ternary_lanes<R, A, B, C, Op, false>};
}

/// Calls `use` with a zero of the C++ type. False: the type is no integer.
template <class Use>
bool with_integer(Type type, Use use) {
  switch (type) {
    case Type::u8:
    case Type::b8:
      use(std::uint8_t());
      return true;
    case Type::s8:
      use(std::int8_t());
      return true;
    case Type::u16:
    case Type::b16:
      use(std::uint16_t());
      return true;
    case Type::s16:
      use(std::int16_t());
      return true;
    case Type::u32:
    case Type::b32:
      use(std::uint32_t());
      return true;
    case Type::s32:
      use(std::int32_t());
      return true;
    case Type::u64:
    case Type::b64:
      use(std::uint64_t());
      return true;
    case Type::s64:
      use(std::int64_t());
      return true;
    default:
      return false;
  }
}
template <class Use>
bool with_floating(Type type, Use use) {
  if (type == Type::f32) return use(float()), true;
  if (type == Type::f64) return use(double()), true;
  return false;
}
template <class Use>
bool with_number(Type type, Use use) {
  return with_integer(type, use) || with_floating(type, use);
}

}  // namespace emulate
