// Sums, products, quotients, roots and powers.
#include "arithmetic.hpp"

namespace emulate {

namespace {

// Division of integers traps on a processor, so lanes that are not there must not divide.
template <class T, bool Remainder>
void divide(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<Slot<T>>(w, i.d);
  const auto* a = source<Slot<T>>(w, i.a);
  const auto* b = source<Slot<T>>(w, i.b);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const T x = value_of<T>(a[l]), y = value_of<T>(b[l]);
    T r;
    if (y == 0)
      r = Remainder ? x : T(~T(0));
    else if (std::is_signed_v<T> && y == T(-1))
      r = Remainder ? T(0) : T(-x);
    else
      r = Remainder ? T(x % y) : T(x / y);
    d[l] = bits_of<T>(r);
  }
}

// Sums with carry.
template <class T, int Op>  // 0 add, 1 sub, 2 mad.lo, 3 mad.hi
void with_carry(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<T>(w, i.d);
  const T *a = source<T>(w, i.a), *b = source<T>(w, i.b), *c = Op >= 2 ? source<T>(w, i.c) : nullptr;
  const bool in = i.number & 1, out = i.number & 2;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const T carry = in ? (w.carry >> l) & 1 : 0;
    unsigned __int128 r;
    if (Op == 0)
      r = static_cast<unsigned __int128>(a[l]) + b[l] + carry;
    else if (Op == 1)
      r = static_cast<unsigned __int128>(a[l]) - b[l] - carry;
    else if (Op == 2)
      r = static_cast<unsigned __int128>(static_cast<T>(a[l] * b[l])) + c[l] + carry;
    else
      r = static_cast<unsigned __int128>(high<T>(a[l], b[l])) + c[l] + carry;
    if (out) w.carry = (w.carry & ~(1u << l)) | (static_cast<std::uint32_t>((r >> (8 * sizeof(T))) & 1) << l);
    d[l] = static_cast<T>(r);
  }
}

}  // namespace

bool choose_sum(Choice& choice) {
  const Statement& s = choice.s;
  const std::string& op = choice.op;
  const Type type = choice.type;
  const bool floating = choice.floating(), saturated = s.has("sat"), lo = s.has("lo"), hi = s.has("hi"),
             wide = s.has("wide");
  const bool carries = s.has("cc") || op == "addc" || op == "subc" || op == "madc";
  if (carries) {
    choice.made.number = (op == "addc" || op == "subc" || op == "madc" ? 1 : 0) | (s.has("cc") ? 2 : 0);
    const int kind = op.starts_with("add") ? 0 : op.starts_with("sub") ? 1 : lo ? 2 : 3;
    const bool big = size_of(type) == 8;
    if (kind == 0) choice.one(big ? with_carry<std::uint64_t, 0> : with_carry<std::uint32_t, 0>);
    if (kind == 1) choice.one(big ? with_carry<std::uint64_t, 1> : with_carry<std::uint32_t, 1>);
    if (kind == 2) choice.one(big ? with_carry<std::uint64_t, 2> : with_carry<std::uint32_t, 2>);
    if (kind == 3) choice.one(big ? with_carry<std::uint64_t, 3> : with_carry<std::uint32_t, 3>);
  } else if (op == "add") {
    if (saturated && !floating) return true;
    INTEGERS((binary<T, T, T, Add>()));
    if (saturated)
      FLOATS((binary<T, T, T, AddSat>()));
    else
      FLOATS((binary<T, T, T, Add>()));
  } else if (op == "sub") {
    if (saturated && !floating) return true;
    INTEGERS((binary<T, T, T, Subtract>()));
    if (saturated)
      FLOATS((binary<T, T, T, SubtractSat>()));
    else
      FLOATS((binary<T, T, T, Subtract>()));
  } else if (op == "mul") {
    if (saturated)
      FLOATS((binary<T, T, T, MultiplySat>()));
    else
      FLOATS((binary<T, T, T, Multiply>()));
    if (lo) INTEGERS((binary<T, T, T, Multiply>()));
    if (hi) INTEGERS((binary<T, T, T, MultiplyHigh>()));
    if (wide) INTEGERS((binary<Wide<T>, T, T, MultiplyWide>()));
  } else if (op == "mad" && !floating) {
    if (lo) INTEGERS((ternary<T, T, T, T, MultiplyAdd>()));
    if (hi) INTEGERS((ternary<T, T, T, T, MultiplyAddHigh>()));
    if (wide) INTEGERS((ternary<Wide<T>, T, T, Wide<T>, MultiplyAddWide>()));
  } else if (op == "fma" || op == "mad") {
    if (saturated)
      FLOATS((ternary<T, T, T, T, FusedSat>()));
    else
      FLOATS((ternary<T, T, T, T, Fused>()));
  } else if (op == "div" && floating) {
    choice.made.kind = class_of(type, true);
    FLOATS((binary<T, T, T, DivideF>()));
  } else if (op == "div") {
    with_integer(type, [&](auto zero) { choice.one(divide<decltype(zero), false>); });
  } else if (op == "rem") {
    with_integer(type, [&](auto zero) { choice.one(divide<decltype(zero), true>); });
  } else if (op == "min") {
    INTEGERS((binary<T, T, T, Minimum>()));
    FLOATS((binary<T, T, T, Minimum>()));
  } else if (op == "max") {
    INTEGERS((binary<T, T, T, Maximum>()));
    FLOATS((binary<T, T, T, Maximum>()));
  } else if (op == "neg") {
    INTEGERS((unary<T, T, Negate>()));
    FLOATS((unary<T, T, Negate>()));
  } else if (op == "abs") {
    INTEGERS((unary<T, T, Absolute>()));
    FLOATS((unary<T, T, AbsoluteF>()));
  } else if (op == "sad") {
    INTEGERS((ternary<T, T, T, T, Sad>()));
  } else if (op == "copysign") {
    FLOATS((binary<T, T, T, CopySign>()));
  } else if (op == "rcp" || op == "sqrt" || op == "rsqrt" || op == "ex2" || op == "lg2" || op == "sin" || op == "cos" ||
             op == "tanh") {
    choice.made.kind = class_of(type, true);
    if (op == "rcp") FLOATS((unary<T, T, Reciprocal>()));
    if (op == "sqrt") FLOATS((unary<T, T, Root>()));
    if (op == "rsqrt") FLOATS((unary<T, T, ReciprocalRoot>()));
    if (op == "ex2") FLOATS((unary<T, T, Exp2>()));
    if (op == "lg2") FLOATS((unary<T, T, Log2>()));
    if (op == "sin") FLOATS((unary<T, T, Sine>()));
    if (op == "cos") FLOATS((unary<T, T, Cosine>()));
    if (op == "tanh") FLOATS((unary<T, T, Tanh>()));
  } else {
    return false;
  }
  return true;
}

}  // namespace emulate
