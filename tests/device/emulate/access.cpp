// Loads, stores and atomics.
#include <atomic>
#include <cstring>

#include "lanes.hpp"

namespace emulate {

namespace {

constexpr std::uint8_t wide_register = 1;

template <class T, class S>
void load_to(Warp& w, std::uint32_t to, std::uint32_t mask, char* const* at, int shift) {
  if (to == nowhere) return;
  auto* d = target<S>(w, to);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    T v;
    std::memcpy(&v, at[l] + shift, sizeof v);
    d[l] = static_cast<S>(v);
  }
}
template <class T>
void load(Warp& w, const Instruction& i, std::uint32_t mask) {
  char* at[32];
  const std::uint32_t good = places(w, i, mask, at);
  static constexpr char zeros[16] = {};
  if (good != mask)
    for (std::uint32_t m = mask & ~good; m; m &= m - 1) at[std::countr_zero(m)] = const_cast<char*>(zeros);
  for (int k = 0; k < i.width; ++k) {
    const std::uint32_t to = i.width == 1 ? i.d : w.group->kernel->further[i.more + k].at;
    if (i.op & wide_register)
      load_to<T, std::uint64_t>(w, to, mask, at, k * sizeof(T));
    else
      load_to<T, std::uint32_t>(w, to, mask, at, k * sizeof(T));
  }
}
template <class T>
void store(Warp& w, const Instruction& i, std::uint32_t mask) {
  char* at[32];
  mask = places(w, i, mask, at);
  for (int k = 0; k < i.width; ++k) {
    const Place from = i.width == 1 ? i.b : w.group->kernel->further[i.more + k];
    if (i.op & wide_register) {
      const auto* s = source<std::uint64_t>(w, from);
      for (std::uint32_t m = mask; m; m &= m - 1) {
        const int l = std::countr_zero(m);
        const T v = static_cast<T>(s[l]);
        std::memcpy(at[l] + k * sizeof(T), &v, sizeof v);
      }
    } else {
      const auto* s = source<std::uint32_t>(w, from);
      for (std::uint32_t m = mask; m; m &= m - 1) {
        const int l = std::countr_zero(m);
        const T v = static_cast<T>(s[l]);
        std::memcpy(at[l] + k * sizeof(T), &v, sizeof v);
      }
    }
    if (w.group->check < 2 || i.space != Space::shared) continue;
    // Lanes that write the same number to one place do no harm.
    for (std::uint32_t m = mask; m; m &= m - 1) {
      const int l = std::countr_zero(m);
      T found;
      std::memcpy(&found, at[l] + k * sizeof(T), sizeof found);
      if (found != (i.op & wide_register ? static_cast<T>(source<std::uint64_t>(w, from)[l])
                                         : static_cast<T>(source<std::uint32_t>(w, from)[l])))
        fault(w, l, i.line, "race within a warp: lanes write unlike numbers to one place of shared memory");
    }
  }
}

enum Atomic : std::uint8_t { add, least, most, both, either, exclusive, exchange, compare, increase, decrease };

template <class T, Atomic Op>
void atomic(Warp& w, const Instruction& i, std::uint32_t mask) {
  char* at[32];
  mask = places(w, i, mask, at);
  auto* d = i.d == nowhere ? nullptr : target<Slot<T>>(w, i.d);
  const auto* b = source<Slot<T>>(w, i.b);
  const auto* c = Op == compare ? source<Slot<T>>(w, i.c) : nullptr;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const std::atomic_ref<Slot<T>> place(*reinterpret_cast<Slot<T>*>(at[l]));
    Slot<T> old = place.load();
    for (;;) {
      const T x = value_of<T>(old), y = value_of<T>(b[l]);
      T made = x;
      if constexpr (Op == add) made = static_cast<T>(x + y);
      if constexpr (Op == least) made = y < x ? y : x;
      if constexpr (Op == most) made = y > x ? y : x;
      if constexpr (Op == exchange) made = y;
      if constexpr (std::is_integral_v<T>) {
        if constexpr (Op == both) made = x & y;
        if constexpr (Op == either) made = x | y;
        if constexpr (Op == exclusive) made = x ^ y;
        if constexpr (Op == compare) made = x == y ? value_of<T>(c[l]) : x;
        if constexpr (Op == increase) made = x >= y ? 0 : x + 1;
        if constexpr (Op == decrease) made = x == 0 || x > y ? y : x - 1;
      }
      if (place.compare_exchange_weak(old, bits_of<T>(made))) break;
    }
    if (d) d[l] = old;
  }
}

template <class T>
Handler atomic_named(const std::string& name) {
  if (name == "add") return atomic<T, add>;
  if (name == "min") return atomic<T, least>;
  if (name == "max") return atomic<T, most>;
  if (name == "exch") return atomic<T, exchange>;
  if constexpr (std::is_integral_v<T>) {
    if (name == "and") return atomic<T, both>;
    if (name == "or") return atomic<T, either>;
    if (name == "xor") return atomic<T, exclusive>;
    if (name == "cas") return atomic<T, compare>;
    if (name == "inc") return atomic<T, increase>;
    if (name == "dec") return atomic<T, decrease>;
  }
  return nullptr;
}

}  // namespace

bool choose_access(const Statement& s, Instruction& made, int register_bytes, int address_bytes) {
  Type type = Type::none;
  static const std::map<std::string_view, Space> spaces = {
      {"global", Space::global},      {"shared", Space::shared},    {"local", Space::local},
      {"const", Space::constant},     {"param", Space::param},      {"shared::cta", Space::shared},
      {"param::entry", Space::param}, {"param::func", Space::param}};
  made.width = 1;
  for (std::size_t k = 1; k < s.words.size(); ++k) {
    if (const auto t = type_named(s.words[k])) type = *t;
    if (const auto found = spaces.find(s.words[k]); found != spaces.end()) made.space = found->second;
    if (s.words[k] == "v2") made.width = 2;
    if (s.words[k] == "v4") made.width = 4;
    if (s.words[k] == "v8") made.width = 8;
    if (s.words[k] == "b128") return false;
  }
  if (type == Type::none) return false;
  made.bytes = static_cast<std::uint8_t>(size_of(type));
  made.wide_address = address_bytes == 8;
  Handler h = nullptr;
  const std::string& op = s.words[0];
  if (op == "ld" || op == "ldu") {
    made.op = register_bytes == 8 ? wide_register : 0;
    switch (type) {
      case Type::u8:
      case Type::b8:
        h = load<std::uint8_t>;
        break;
      case Type::s8:
        h = load<std::int8_t>;
        break;
      case Type::u16:
      case Type::b16:
      case Type::f16:
        h = load<std::uint16_t>;
        break;
      case Type::s16:
        h = load<std::int16_t>;
        break;
      case Type::u32:
      case Type::b32:
      case Type::f32:
        h = load<std::uint32_t>;
        break;
      case Type::s32:
        h = load<std::int32_t>;
        break;
      default:
        h = load<std::uint64_t>;
    }
    made.kind = made.space == Space::shared                                   ? Class::load_shared
                : made.space == Space::local                                  ? Class::local
                : made.space == Space::param || made.space == Space::constant ? Class::param
                                                                              : Class::load_global;
  } else if (op == "st") {
    made.is_store = true;
    made.op = register_bytes == 8 ? wide_register : 0;
    h = made.bytes == 1   ? store<std::uint8_t>
        : made.bytes == 2 ? store<std::uint16_t>
        : made.bytes == 4 ? store<std::uint32_t>
                          : store<std::uint64_t>;
    made.kind = made.space == Space::shared  ? Class::store_shared
                : made.space == Space::local ? Class::local
                : made.space == Space::param ? Class::param
                                             : Class::store_global;
  } else {
    made.is_atomic = true;
    made.kind = Class::atomic;
    std::string name;
    for (const auto& word : s.words)
      for (const char* known : {"add", "min", "max", "exch", "and", "or", "xor", "cas", "inc", "dec"})
        if (word == known) name = word;
    switch (type) {
      case Type::u32:
      case Type::b32:
        h = atomic_named<std::uint32_t>(name);
        break;
      case Type::s32:
        h = atomic_named<std::int32_t>(name);
        break;
      case Type::u64:
      case Type::b64:
        h = atomic_named<std::uint64_t>(name);
        break;
      case Type::s64:
        h = atomic_named<std::int64_t>(name);
        break;
      case Type::f32:
        h = atomic_named<float>(name);
        break;
      case Type::f64:
        h = atomic_named<double>(name);
        break;
      default:
        return false;
    }
  }
  made.full = made.part = h;
  return h != nullptr;
}

}  // namespace emulate
