// Logic, shifts and fields of bits.
#include "arithmetic.hpp"

namespace emulate {

namespace {

template <class T>
void insert_field(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<T>(w, i.d);
  const T *a = source<T>(w, i.a), *b = source<T>(w, i.b);
  const auto *c = source<std::uint32_t>(w, i.c), *e = source<std::uint32_t>(w, i.e);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const std::uint32_t begin = c[l] & 255, length = e[l] & 255, bits = 8 * sizeof(T);
    T field = length >= bits ? ~T(0) : (T(1) << length) - 1;
    field = begin >= bits ? 0 : field << begin;
    d[l] = (begin >= bits ? b[l] : ((a[l] << begin) & field) | (b[l] & ~field));
  }
}

template <bool Full>
void logic(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<std::uint32_t>(w, i.d);
  const auto *a = source<std::uint32_t>(w, i.a), *b = source<std::uint32_t>(w, i.b), *c = source<std::uint32_t>(w, i.c);
  std::uint32_t on[8];
  for (int k = 0; k < 8; ++k) on[k] = -static_cast<std::uint32_t>((i.number >> k) & 1);
#pragma GCC ivdep
  for (int l = 0; l < 32; ++l) {
    const std::uint32_t x = a[l], y = b[l], z = c[l];
    const std::uint32_t r = (on[0] & ~x & ~y & ~z) | (on[1] & ~x & ~y & z) | (on[2] & ~x & y & ~z) |
                            (on[3] & ~x & y & z) | (on[4] & x & ~y & ~z) | (on[5] & x & ~y & z) | (on[6] & x & y & ~z) |
                            (on[7] & x & y & z);
    put<Full>(d, l, r, mask);
  }
}

template <class T>
void find_leading(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<Slot<T>>(w, i.a);
  auto* d = target<std::uint32_t>(w, i.d);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    T x = value_of<T>(a[l]);
    if (std::is_signed_v<T> && x < 0) x = ~x;
    const int zeros = std::countl_zero(static_cast<Unsigned<T>>(x)), bits = 8 * sizeof(T);
    d[l] = x == 0 ? ~0u : static_cast<std::uint32_t>(i.number ? zeros : bits - 1 - zeros);
  }
}

}  // namespace

bool choose_bits(Choice& choice) {
  const Statement& s = choice.s;
  const std::string& op = choice.op;
  const Type type = choice.type;
  if (op == "and") {
    INTEGERS((binary<T, T, T, And>()));
  } else if (op == "or") {
    INTEGERS((binary<T, T, T, Or>()));
  } else if (op == "xor") {
    INTEGERS((binary<T, T, T, Xor>()));
  } else if (op == "not") {
    INTEGERS((unary<T, T, Not>()));
  } else if (op == "cnot") {
    INTEGERS((unary<T, T, CNot>()));
  } else if (op == "shl") {
    INTEGERS((binary<T, T, std::uint32_t, ShiftLeft>()));
  } else if (op == "shr") {
    INTEGERS((binary<T, T, std::uint32_t, ShiftRight>()));
  } else if (op == "shf") {
    using U = std::uint32_t;
    const bool left = s.has("l"), clamp = s.has("clamp");
    choice.h = left ? (clamp ? ternary<U, U, U, U, FunnelLeftClamp>() : ternary<U, U, U, U, FunnelLeftWrap>())
                    : (clamp ? ternary<U, U, U, U, FunnelRightClamp>() : ternary<U, U, U, U, FunnelRightWrap>());
  } else if (op == "lop3") {
    choice.h = {logic<true>, logic<false>};
  } else if (op == "prmt") {
    if (s.words.size() != 2) return true;
    choice.h = ternary<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, Permute>();
  } else if (op == "bfe") {
    with_integer(type, [&](auto zero) {
      using T = decltype(zero);
      choice.h = ternary<T, T, std::uint32_t, std::uint32_t, Field>();
    });
  } else if (op == "bfi") {
    choice.one(size_of(type) == 8 ? insert_field<std::uint64_t> : insert_field<std::uint32_t>);
  } else if (op == "brev") {
    choice.h = size_of(type) == 8 ? unary<std::uint64_t, std::uint64_t, Reverse64>()
                                  : unary<std::uint32_t, std::uint32_t, Reverse32>();
  } else if (op == "popc") {
    choice.h = size_of(type) == 8 ? unary<std::uint32_t, std::uint64_t, Population>()
                                  : unary<std::uint32_t, std::uint32_t, Population>();
  } else if (op == "clz") {
    choice.h = size_of(type) == 8 ? unary<std::uint32_t, std::uint64_t, LeadingZeros>()
                                  : unary<std::uint32_t, std::uint32_t, LeadingZeros>();
  } else if (op == "bfind") {
    choice.made.number = s.has("shiftamt");
    with_integer(type, [&](auto zero) { choice.one(find_leading<decltype(zero)>); });
  } else {
    return false;
  }
  return true;
}

}  // namespace emulate
