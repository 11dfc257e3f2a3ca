// Moves, and conversions of numbers and of addresses.
#include <limits>

#include "arithmetic.hpp"

namespace emulate {

namespace {

template <class F>
F rounded_to_integer(F x, int mode) {
  switch (mode) {
    case rzi:
      return std::trunc(x);
    case rmi:
      return std::floor(x);
    case rpi:
      return std::ceil(x);
    default:
      return std::nearbyint(x);
  }
}
template <class D, class S>
D converted(S s, int mode, bool saturated) {
  if constexpr (std::is_floating_point_v<D>) {
    if constexpr (std::is_floating_point_v<S>) {
      const S x = mode >= rni ? rounded_to_integer(s, mode) : s;
      const D d = static_cast<D>(x);
      return saturated ? sat01(d) : d;
    } else {
      return static_cast<D>(s);
    }
  } else if constexpr (std::is_floating_point_v<S>) {
    const S x = rounded_to_integer(s, mode);
    if (x != x)
      return sizeof(D) == 8 && sizeof(S) >= 4
                 ? (std::is_signed_v<D> ? std::numeric_limits<D>::min() : std::numeric_limits<D>::max())
                 : D(0);
    constexpr S low = static_cast<S>(std::numeric_limits<D>::min());
    const S top = std::ldexp(S(1), std::numeric_limits<D>::digits);
    if (x <= low) return std::numeric_limits<D>::min();
    if (x >= top) return std::numeric_limits<D>::max();
    return static_cast<D>(x);
  } else {
    if (!saturated) return static_cast<D>(s);
    using W = __int128;
    const W x = s, low = std::numeric_limits<D>::min(), top = std::numeric_limits<D>::max();
    return static_cast<D>(x < low ? low : x > top ? top : x);
  }
}
template <class D, class S>
void convert(Warp& w, const Instruction& i, std::uint32_t mask) {
  const int mode = i.number & 15;
  const bool saturated = i.number & 16, wide_d = i.number & 32, wide_s = i.number & 64;
  const bool plain = !saturated && (mode == rn || (!std::is_floating_point_v<S> && !std::is_floating_point_v<D>));
  if (wide_d == (sizeof(D) == 8) && wide_s == (sizeof(S) == 8) && plain &&
      (std::is_floating_point_v<D> || !std::is_floating_point_v<S>)) {
    auto* d = target<Slot<D>>(w, i.d);
    const auto* s = source<Slot<S>>(w, i.a);
    alignas(64) Slot<D> made[32];
    for (int l = 0; l < 32; ++l) made[l] = bits_of<D>(static_cast<D>(value_of<S>(s[l])));
    for (int l = 0; l < 32; ++l) put<false>(d, l, made[l], mask);
    return;
  }
  const auto* narrow = source<std::uint32_t>(w, i.a);
  const auto* broad = source<std::uint64_t>(w, i.a);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const D made = converted<D, S>(value_of<S>(static_cast<Slot<S>>(wide_s ? broad[l] : narrow[l])), mode, saturated);
    if (wide_d)
      target<std::uint64_t>(w, i.d)[l] =
          std::is_floating_point_v<D> ? bits_of<D>(made) : static_cast<std::uint64_t>(made);
    else
      target<std::uint32_t>(w, i.d)[l] = static_cast<std::uint32_t>(bits_of<D>(made));
  }
}

// Parts of 64 bits (or of 32) joined and taken apart.
void join(Warp& w, const Instruction& i, std::uint32_t mask) {
  const Place* parts = &w.group->kernel->further[i.more];
  const int bits = i.bytes * 8;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    std::uint64_t all = 0;
    const std::uint64_t cut = (std::uint64_t(1) << bits) - 1;
    for (int k = 0; k < i.width; ++k) all |= (source<std::uint32_t>(w, parts[k])[l] & cut) << (k * bits);
    if (i.width * bits == 64)
      target<std::uint64_t>(w, i.d)[l] = all;
    else
      target<std::uint32_t>(w, i.d)[l] = static_cast<std::uint32_t>(all);
  }
}
void split(Warp& w, const Instruction& i, std::uint32_t mask) {
  const Place* parts = &w.group->kernel->further[i.more];
  const int bits = i.bytes * 8;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const std::uint64_t all =
        i.width * bits == 64 ? source<std::uint64_t>(w, i.a)[l] : source<std::uint32_t>(w, i.a)[l];
    const std::uint64_t cut = (std::uint64_t(1) << bits) - 1;
    for (int k = 0; k < i.width; ++k)
      if (parts[k].at != nowhere)
        target<std::uint32_t>(w, parts[k].at)[l] = static_cast<std::uint32_t>((all >> (k * bits)) & cut);
  }
}

// Addresses: of shared and local memory as numbers from 0 in their spaces, generic ones as addresses of the host.
template <bool Up>
void convert_address(Warp& w, const Instruction& i, std::uint32_t mask) {
  auto* d = target<std::uint64_t>(w, i.d);
  const auto* a = source<std::uint64_t>(w, i.a);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const std::uint64_t base = i.space == Space::shared  ? reinterpret_cast<std::uint64_t>(w.group->shared)
                               : i.space == Space::local ? reinterpret_cast<std::uint64_t>(w.local[l])
                               : i.space == Space::param ? reinterpret_cast<std::uint64_t>(w.group->params)
                                                         : 0;
    d[l] = Up ? a[l] + base : a[l] - base;
  }
}
void in_space(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<std::uint64_t>(w, i.a);
  std::uint32_t found = 0;
  const auto in = [](std::uint64_t x, const char* begin, std::int64_t bytes) {
    return x - reinterpret_cast<std::uint64_t>(begin) < static_cast<std::uint64_t>(bytes);
  };
  for (int l = 0; l < 32; ++l) {
    const bool shared = in(a[l], w.group->shared, w.group->shared_bytes),
               local = in(a[l], w.group->local, w.group->local_all),
               param = in(a[l], w.group->params, w.group->kernel->param_bytes);
    const bool truth = i.space == Space::shared                                ? shared
                       : i.space == Space::local                               ? local
                       : i.space == Space::param || i.space == Space::constant ? param
                                                                               : !shared && !local && !param;
    found |= static_cast<std::uint32_t>(truth) << l;
  }
  put_predicate(w, i.d, found, mask);
}
}  // namespace

bool choose_conversion(Choice& choice) {
  const Statement& s = choice.s;
  const std::string& op = choice.op;
  const Type type = choice.type;
  if (op == "mov") {
    choice.made.kind = Class::move;
    if (size_of(type) == 8)
      choice.h = unary<std::uint64_t, std::uint64_t, Move>();
    else
      choice.h = unary<std::uint32_t, std::uint32_t, Move>();
    if (choice.made.op == 1) choice.one(join);
    if (choice.made.op == 2) choice.one(split);
  } else if (op == "cvt") {
    choice.made.kind = Class::convert;
    static const std::map<std::string_view, int> modes = {{"rn", rn},   {"rz", rz},   {"rm", rm},   {"rp", rp},
                                                          {"rni", rni}, {"rzi", rzi}, {"rmi", rmi}, {"rpi", rpi}};
    int mode = rn;
    for (const auto& word : s.words)
      if (const auto found = modes.find(word); found != modes.end()) mode = found->second;
    choice.made.number =
        mode | (s.has("sat") ? 16 : 0) | (choice.widths[0] == 8 ? 32 : 0) | (choice.widths[1] == 8 ? 64 : 0);
    with_number(choice.second, [&](auto to) {
      with_number(type, [&](auto from) { choice.one(convert<decltype(to), decltype(from)>); });
    });
    if (mode >= rz && mode <= rp && choice.h.full) {
      choice.made.op = static_cast<std::uint8_t>(mode);
      choice.made.inner = choice.h.full;
      choice.made.number = (choice.made.number & ~15) | rn;
      choice.one(with_rounding);
    }
  } else if (op == "cvta" || op == "isspacep") {
    choice.made.kind = Class::integer;
    for (const auto& word : s.words)
      choice.made.space = word.starts_with("shared")  ? Space::shared
                          : word == "local"           ? Space::local
                          : word.starts_with("param") ? Space::param
                          : word == "global"          ? Space::global
                          : word == "const"           ? Space::constant
                                                      : choice.made.space;
    choice.one(op == "isspacep" ? in_space : s.has("to") ? convert_address<false> : convert_address<true>);
    if (op == "cvta" && (choice.made.space == Space::global || choice.made.space == Space::constant))
      choice.h = unary<std::uint64_t, std::uint64_t, Move>();
  } else {
    return false;
  }
  return true;
}

}  // namespace emulate
