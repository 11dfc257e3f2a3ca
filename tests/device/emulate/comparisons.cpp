// Comparisons, predicates and selections.
#include "arithmetic.hpp"

namespace emulate {

namespace {

template <class T, bool Full>
void select(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<T>(w, i.d);
  const T *a = source<T>(w, i.a), *b = source<T>(w, i.b);
  std::uint32_t p = predicate(w, i.c);
  if (i.number) p = ~p;
#pragma GCC ivdep
  for (int l = 0; l < 32; ++l) {
    const T m = -static_cast<T>((p >> l) & 1);
    put<Full>(d, l, static_cast<T>((a[l] & m) | (b[l] & ~m)), mask);
  }
}
template <class T, class C>
void select_by_sign(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<T>(w, i.d);
  const T *a = source<T>(w, i.a), *b = source<T>(w, i.b);
  const auto* c = source<Slot<C>>(w, i.c);
  for (int l = 0; l < 32; ++l) put<false>(d, l, value_of<C>(c[l]) >= 0 ? a[l] : b[l], mask);
}

// NOLINTBEGIN
#define COMPARE(Name, expression) \
  struct Name {                   \
    template <class T>            \
    static bool of(T a, T b) {    \
      return expression;          \
    }                             \
  };
// NOLINTEND
COMPARE(Eq, a == b)
COMPARE(Ne, a<b || a> b)
COMPARE(NeI, a != b)
COMPARE(Lt, a < b)
COMPARE(Le, a <= b)
COMPARE(Gt, a > b)
COMPARE(Ge, a >= b)
COMPARE(Equ, !(a < b || a > b))
COMPARE(Neu, !(a == b))
COMPARE(Ltu, !(a >= b))
COMPARE(Leu, !(a > b))
COMPARE(Gtu, !(a <= b))
COMPARE(Geu, !(a < b))
COMPARE(Num, a == a && b == b)
COMPARE(Nan, a != a || b != b)

inline std::uint32_t joined(int op, std::uint32_t x, std::uint32_t c) {
  return op == 1 ? x & c : op == 2 ? x | c : op == 3 ? x ^ c : x;
}

template <class T, class Op>
void set_predicate(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<Slot<T>>(w, i.a);
  const auto* b = source<Slot<T>>(w, i.b);
  alignas(64) std::uint8_t truth[32];
  for (int l = 0; l < 32; ++l) truth[l] = Op::template of<T>(value_of<T>(a[l]), value_of<T>(b[l]));
  const std::uint32_t found = packed(truth);
  std::uint32_t c = 0;
  if (i.op) c = i.number ? ~predicate(w, i.c) : predicate(w, i.c);
  put_predicate(w, i.d, joined(i.op, found, c), mask);
  put_predicate(w, i.d2, joined(i.op, ~found, c), mask);
}
template <class T, class Op>
void set_value(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<Slot<T>>(w, i.a);
  const auto* b = source<Slot<T>>(w, i.b);
  auto* d = target<std::uint32_t>(w, i.d);
  const bool floating = i.number & 2;
  for (int l = 0; l < 32; ++l) {
    const bool truth = Op::template of<T>(value_of<T>(a[l]), value_of<T>(b[l]));
    put<false>(d, l, truth ? (floating ? 0x3f800000u : ~0u) : 0u, mask);
  }
}

// NOLINTBEGIN
#define PREDICATE(name, expression)                                    \
  void name(Warp& w, const Instruction& i, std::uint32_t mask) {       \
    const std::uint32_t a = predicate(w, i.a);                         \
    const std::uint32_t b = i.b.at != nowhere ? predicate(w, i.b) : 0; \
    (void)b;                                                           \
    put_predicate(w, i.d, expression, mask);                           \
  }
// NOLINTEND
PREDICATE(predicate_move, a)
PREDICATE(predicate_not, ~a)
PREDICATE(predicate_and, a& b)
PREDICATE(predicate_or, a | b)
PREDICATE(predicate_xor, a ^ b)

template <class T>
void test_property(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<Slot<T>>(w, i.a);
  std::uint32_t found = 0;
  for (int l = 0; l < 32; ++l) {
    const T x = value_of<T>(a[l]);
    const bool truth = i.op == 0   ? std::isfinite(x)
                       : i.op == 1 ? std::isinf(x)
                       : i.op == 2 ? !std::isnan(x)
                       : i.op == 3 ? std::isnan(x)
                       : i.op == 4 ? std::isnormal(x)
                                   : std::fpclassify(x) == FP_SUBNORMAL;
    found |= static_cast<std::uint32_t>(truth) << l;
  }
  put_predicate(w, i.d, found, mask);
}
template <template <class, class> class Use>
Handler chosen_comparison(const std::string& name, Type type) {
  Handler made = nullptr;
  const auto all = [&](auto zero) {
    using T = decltype(zero);
    constexpr bool f = std::is_floating_point_v<T>;
    if (name == "eq")
      made = Use<T, Eq>::handler;
    else if (name == "ne")
      made = f ? Use<T, Ne>::handler : Use<T, NeI>::handler;
    else if (name == "lt" || name == "lo")
      made = Use<T, Lt>::handler;
    else if (name == "le" || name == "ls")
      made = Use<T, Le>::handler;
    else if (name == "gt" || name == "hi")
      made = Use<T, Gt>::handler;
    else if (name == "ge" || name == "hs")
      made = Use<T, Ge>::handler;
    else if (name == "equ")
      made = Use<T, Equ>::handler;
    else if (name == "neu")
      made = Use<T, Neu>::handler;
    else if (name == "ltu")
      made = Use<T, Ltu>::handler;
    else if (name == "leu")
      made = Use<T, Leu>::handler;
    else if (name == "gtu")
      made = Use<T, Gtu>::handler;
    else if (name == "geu")
      made = Use<T, Geu>::handler;
    else if (name == "num")
      made = Use<T, Num>::handler;
    else if (name == "nan")
      made = Use<T, Nan>::handler;
  };
  with_number(type, all);
  return made;
}
template <class T, class Op>
struct ForPredicate {
  static constexpr Handler handler = set_predicate<T, Op>;
};
template <class T, class Op>
struct ForValue {
  static constexpr Handler handler = set_value<T, Op>;
};

}  // namespace

bool choose_comparison(Choice& choice) {
  const Statement& s = choice.s;
  const std::string& op = choice.op;
  const Type type = choice.type;
  if (type == Type::pred && (op == "and" || op == "or" || op == "xor" || op == "not" || op == "mov")) {
    choice.one(op == "and"   ? predicate_and
               : op == "or"  ? predicate_or
               : op == "xor" ? predicate_xor
               : op == "not" ? predicate_not
                             : predicate_move);
  } else if (op == "testp") {
    const char* names[] = {"finite", "infinite", "number", "notanumber", "normal", "subnormal"};
    for (int k = 0; k < 6; ++k)
      if (s.has(names[k])) choice.made.op = static_cast<std::uint8_t>(k);
    choice.one(type == Type::f64 ? test_property<double> : test_property<float>);
  } else if (op == "selp") {
    choice.made.kind = Class::move;
    choice.made.number = s.operands[3].negated;
    if (size_of(type) == 8)
      choice.h = {select<std::uint64_t, true>, select<std::uint64_t, false>};
    else
      choice.h = {select<std::uint32_t, true>, select<std::uint32_t, false>};
  } else if (op == "slct") {
    // slct.dtype.ctype: the last type is that of c
    const bool big = size_of(choice.second) == 8;
    if (type == Type::f32)
      choice.one(big ? select_by_sign<std::uint64_t, float> : select_by_sign<std::uint32_t, float>);
    else
      choice.one(big ? select_by_sign<std::uint64_t, std::int32_t> : select_by_sign<std::uint32_t, std::int32_t>);
  } else if (op == "setp") {
    choice.made.kind = Class::predicate;
    for (std::size_t k = 2; k + 1 < s.words.size(); ++k)
      choice.made.op = s.words[k] == "and" ? 1 : s.words[k] == "or" ? 2 : s.words[k] == "xor" ? 3 : choice.made.op;
    choice.made.number = s.operands.back().negated;
    if (const Handler found = chosen_comparison<ForPredicate>(s.words[1], type)) choice.one(found);
  } else if (op == "set") {
    choice.made.number = choice.second == Type::f32 ? 2 : 0;
    if (s.operands.size() == 3)
      if (const Handler found = chosen_comparison<ForValue>(s.words[1], type)) choice.one(found);
  } else {
    return false;
  }
  return true;
}

}  // namespace emulate
