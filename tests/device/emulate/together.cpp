// What lanes of a warp do together: shuffles, votes, matches, reductions; and functions of the runtime that kernels call.
#include <cstdio>
#include <mutex>
#include <string>

#include "lanes.hpp"
#include "memory.hpp"

namespace emulate {

namespace {

void shuffle(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto *a = source<std::uint32_t>(w, i.a), *b = source<std::uint32_t>(w, i.b), *c = source<std::uint32_t>(w, i.c);
  std::uint32_t made[32], inside = 0;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const int by = static_cast<int>(b[l] & 31), clamp = static_cast<int>(c[l] & 31),
              segment = static_cast<int>((c[l] >> 8) & 31);
    const int top = (l & segment) | (clamp & ~segment), low = l & segment;
    int from = l;
    bool good = true;
    if (i.op == 0)
      from = l - by, good = from >= top;
    else if (i.op == 1)
      from = l + by, good = from <= top;
    else if (i.op == 2)
      from = l ^ by, good = from <= top;
    else
      from = low | (by & ~segment), good = from <= top;
    if (!good) from = l;
    if (good && !(mask >> from & 1) && w.group->check)
      fault(w, l, i.line, std::string(i.opcode) + " from lane " + std::to_string(from) + ", which takes no part");
    made[l] = a[from & 31];
    inside |= static_cast<std::uint32_t>(good) << l;
  }
  if (i.d != nowhere) {
    auto* d = target<std::uint32_t>(w, i.d);
    for (std::uint32_t m = mask; m; m &= m - 1) d[std::countr_zero(m)] = made[std::countr_zero(m)];
  }
  put_predicate(w, i.d2, inside, mask);
}

void vote(Warp& w, const Instruction& i, std::uint32_t mask) {
  std::uint32_t p = predicate(w, i.a);
  if (i.number) p = ~p;
  p &= mask;
  if (i.op == 13) {
    auto* d = target<std::uint32_t>(w, i.d);
    for (std::uint32_t m = mask; m; m &= m - 1) d[std::countr_zero(m)] = p;
  } else {
    const bool truth = i.op == 10 ? p == mask : i.op == 11 ? p != 0 : p == 0 || p == mask;
    put_predicate(w, i.d, truth ? ~0u : 0u, mask);
  }
}

void match(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto value = [&](int l) -> std::uint64_t {
    return i.bytes == 8 ? source<std::uint64_t>(w, i.a)[l] : source<std::uint32_t>(w, i.a)[l];
  };
  std::uint32_t made[32];
  bool all = true;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    made[l] = 0;
    for (std::uint32_t o = mask; o; o &= o - 1)
      if (value(std::countr_zero(o)) == value(l)) made[l] |= 1u << std::countr_zero(o);
    all = all && made[l] == mask;
  }
  if (i.d != nowhere) {
    auto* d = target<std::uint32_t>(w, i.d);
    for (std::uint32_t m = mask; m; m &= m - 1)
      d[std::countr_zero(m)] = i.op == 30 ? made[std::countr_zero(m)] : all ? mask : 0;
  }
  put_predicate(w, i.d2, all ? ~0u : 0u, mask);
}

void reduce(Warp& w, const Instruction& i, std::uint32_t mask) {
  const auto* a = source<std::uint32_t>(w, i.a);
  std::uint32_t r = a[std::countr_zero(mask)];
  for (std::uint32_t m = mask & (mask - 1); m; m &= m - 1) {
    const std::uint32_t x = a[std::countr_zero(m)];
    const bool less = i.number ? static_cast<std::int32_t>(x) < static_cast<std::int32_t>(r) : x < r;
    if (i.op == 40)
      r += x;
    else if (i.op == 41)
      r = less ? x : r;
    else if (i.op == 42)
      r = less ? r : x;
    else if (i.op == 43)
      r &= x;
    else if (i.op == 44)
      r |= x;
    else
      r ^= x;
  }
  auto* d = target<std::uint32_t>(w, i.d);
  for (std::uint32_t m = mask; m; m &= m - 1) d[std::countr_zero(m)] = r;
}

const char* text_at(std::uint64_t address) {
  return static_cast<const char*>(memory().host(reinterpret_cast<const void*>(address)));
}

std::string formatted(const char* format, const char* values) {
  std::string text;
  std::size_t at = 0;
  const auto take = [&](std::size_t bytes) {
    at = (at + bytes - 1) / bytes * bytes;
    std::uint64_t value = 0;
    std::memcpy(&value, values + at, bytes);
    at += bytes;
    return value;
  };
  for (const char* f = format; *f; ++f) {
    if (*f != '%' || f[1] == '%') {
      text += *f;
      if (*f == '%') ++f;
      continue;
    }
    std::string one = "%";
    bool big = false;
    for (++f; *f && !std::strchr("diouxXeEfFgGaAcsp", *f); ++f) {
      if (*f == '*') {
        one += std::to_string(static_cast<int>(take(4)));
        continue;
      }
      if (*f == 'l' || *f == 'z' || *f == 'j' || *f == 't') big = true;
      if (!std::strchr("lhzjt", *f)) one += *f;
    }
    if (!*f) break;
    char made[512];
    if (std::strchr("eEfFgGaA", *f))
      std::snprintf(made, sizeof made, (one + *f).c_str(), std::bit_cast<double>(take(8)));
    else if (*f == 's')
      std::snprintf(made, sizeof made, (one + "s").c_str(), text_at(take(8)));
    else if (*f == 'p')
      std::snprintf(made, sizeof made, "%p", reinterpret_cast<void*>(take(8)));
    else if (big)
      std::snprintf(made, sizeof made, (one + "ll" + *f).c_str(), static_cast<long long>(take(8)));
    else
      std::snprintf(made, sizeof made, (one + *f).c_str(), static_cast<int>(take(4)));
    text += made;
  }
  return text;
}

}  // namespace

void warp_sync(Warp& w, const End& end, std::uint32_t mask) {
  const Instruction& i = end.sync;
  if (i.op <= 3)
    shuffle(w, i, mask);
  else if (i.op <= 13)
    vote(w, i, mask);
  else if (i.op == 20)
    ++w.sync;
  else if (i.op <= 31)
    match(w, i, mask);
  else
    reduce(w, i, mask);
}

void call_host(Warp& w, const End& end, std::uint32_t mask) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const auto argument = [&](std::size_t k) {
      std::uint64_t value;
      std::memcpy(&value, w.local[l] + end.arguments.at(k), sizeof value);
      return value;
    };
    if (end.callee == "vprintf") {
      const std::uint64_t values = argument(1);
      std::fputs(formatted(text_at(argument(0)), values ? text_at(values) : nullptr).c_str(), stdout);
      std::fflush(stdout);
      const int zero = 0;
      if (end.answer >= 0) std::memcpy(w.local[l] + end.answer, &zero, sizeof zero);
    } else if (end.callee == "__assertfail") {
      fault(w, l, end.line, std::string("assertion failed: ") + text_at(argument(0)) + ", " + text_at(argument(1)));
      w.group->stopped = true;
      return;
    } else {
      throw Problem("kernel " + w.group->kernel->name + " calls " + end.callee + ", which is not known");
    }
  }
}

}  // namespace emulate
