// Where lanes read and write, and whether they may.
#include <cstdio>

#include "access.hpp"
#include "memory.hpp"
#include "options.hpp"

namespace emulate {

namespace {

__attribute__((noinline)) std::uint32_t bad_shared(Warp& w, const Instruction& i, std::uint32_t mask,
                                                   const std::uint64_t* address) {
  Group& g = *w.group;
  const unsigned bytes = i.bytes * i.width;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    char text[200];
    if (address[l] + bytes > static_cast<std::uint64_t>(g.shared_bytes) || address[l] + bytes < bytes)
      std::snprintf(text, sizeof text, "%s of %u bytes at byte %lld of %lld bytes of shared memory",
                    i.is_store ? "write" : "read", bytes, static_cast<long long>(address[l]),
                    static_cast<long long>(g.shared_bytes));
    else if (address[l] & (bytes - 1))
      std::snprintf(text, sizeof text, "misaligned access of %u bytes at byte %lld of shared memory", bytes,
                    static_cast<long long>(address[l]));
    else
      continue;
    fault(w, l, i.line, text);
    mask &= ~(1u << l);
  }
  return mask;
}

std::uint32_t shared_places(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* address,
                            char** at) {
  Group& g = *w.group;
  const unsigned bytes = i.bytes * i.width;
  const std::uint64_t most = static_cast<std::uint64_t>(g.shared_bytes) - bytes, low = bytes - 1;
  std::uint64_t bad = 0;
  const bool none = static_cast<std::uint64_t>(g.shared_bytes) < bytes;
  for (int l = 0; l < 32; ++l) {
    const std::uint64_t here = -static_cast<std::uint64_t>((mask >> l) & 1);
    bad |= ((address[l] > most ? ~0ull : 0ull) | (address[l] & low)) & here;
    at[l] = g.shared + address[l];
  }
  if (bad || none) mask = bad_shared(w, i, mask, address);
  if (g.check >= 2) check_lanes(w, i, mask, address, bytes);
  if (g.check >= 1) check_shared(w, i, mask, address, bytes);
  if (g.counting && mask) {
    int least = 0;
    g.counts->shared_cycles += bank_cycles(address, mask, bytes, least);
    g.counts->shared_least += least;
    ++g.counts->shared_accesses;
    if (i.is_atomic) ++g.counts->atomics_shared;
  }
  return mask;
}

__attribute__((noinline)) bool bad_global(Warp& w, const Instruction& i, int lane, std::uint64_t address,
                                          unsigned bytes, char** at) {
  if (memory().pinned(address, bytes)) {
    *at = reinterpret_cast<char*>(address);
    return false;
  }
  fault(w, lane, i.line,
        std::string(i.is_atomic  ? "atomic"
                    : i.is_store ? "write"
                                 : "read") +
            " of " + std::to_string(bytes) + " bytes: " + memory().describe(address));
  return true;
}

std::uint32_t global_places(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* address,
                            char** at) {
  static const DeviceMemory& device = memory();
  const unsigned bytes = i.bytes * i.width;
  std::uint32_t good = mask;
  // Most accesses of an instruction are to one allocation.
  struct Range {
    std::uint64_t begin = 0, length = 0, generation = 0;
  };
  static thread_local Range ranges[1024];
  Range& range = ranges[i.line & 1023];
  const std::uint64_t low = bytes - 1, distance = device.distance();
  std::uint64_t bad = 0;
  if (range.generation == device.generation() && range.length >= bytes) {
    const std::uint64_t begin = range.begin, most = range.length - bytes;
    for (int l = 0; l < 32; ++l) {
      const std::uint64_t here = -static_cast<std::uint64_t>((mask >> l) & 1);
      bad |= ((address[l] - begin > most ? ~0ull : 0ull) | (address[l] & low)) & here;
      at[l] = reinterpret_cast<char*>(address[l] + distance);
    }
  } else {
    bad = 1;
  }
  if (bad) {
    const auto [begin, end] = device.around(address[std::countr_zero(mask)]);
    range = {begin, end - begin, device.generation()};
  }
  for (std::uint32_t m = bad ? mask : 0; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    at[l] = device.host(address[l]);
    if (!device.live(address[l], bytes)) {
      if (bad_global(w, i, l, address[l], bytes, &at[l])) good &= ~(1u << l);
    } else if (address[l] & (bytes - 1)) {
      fault(w, l, i.line, "misaligned access of " + std::to_string(bytes) + " bytes: " + device.describe(address[l]));
      good &= ~(1u << l);
    }
  }
  Group& g = *w.group;
  if (g.counting && i.space != Space::constant) {
    const int found = sectors(address, good, bytes);
    Counts& c = *g.counts;
    ++c.accesses_global;
    const unsigned wanted = bytes * static_cast<unsigned>(std::popcount(good));
    if (i.is_atomic) ++c.atomics_global;
    if (i.is_store || i.is_atomic) c.sectors_written += found, c.bytes_written += wanted;
    if (!i.is_store) c.sectors_read += found, c.bytes_read += wanted;
  }
  return good;
}

std::uint32_t local_places(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* address, char** at) {
  const std::uint64_t all = static_cast<std::uint64_t>(w.group->kernel->local_bytes);
  const unsigned bytes = i.bytes * i.width;
  std::uint32_t good = mask;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    if (address[l] + bytes > all || (address[l] & (bytes - 1))) {
      fault(w, l, i.line,
            "access of " + std::to_string(bytes) + " bytes at byte " + std::to_string(address[l]) + " of " +
                std::to_string(all) + " bytes of local memory");
      good &= ~(1u << l);
    } else {
      at[l] = w.local[l] + address[l];
    }
  }
  if (w.group->counting) ++w.group->counts->local_accesses;
  return good;
}

}  // namespace

std::uint32_t places(Warp& w, const Instruction& i, std::uint32_t mask, char** at) {
  std::uint64_t address[32];
  if (i.wide_address) {
    const auto* a = source<std::uint64_t>(w, i.a);
    for (int l = 0; l < 32; ++l) address[l] = a[l] + static_cast<std::uint64_t>(i.number);
  } else {
    const auto* a = source<std::uint32_t>(w, i.a);
    for (int l = 0; l < 32; ++l) address[l] = static_cast<std::uint32_t>(a[l] + static_cast<std::uint32_t>(i.number));
  }
  Group& g = *w.group;
  switch (i.space) {
    case Space::shared:
      return shared_places(w, i, mask, address, at);
    case Space::global:
    case Space::constant:
      return global_places(w, i, mask, address, at);
    case Space::local:
      return local_places(w, i, mask, address, at);
    case Space::param: {
      if (i.param_is_local) return local_places(w, i, mask, address, at);
      std::uint32_t good = mask;
      for (std::uint32_t m = mask; m; m &= m - 1) {
        const int l = std::countr_zero(m);
        if (address[l] + i.bytes * i.width > static_cast<std::uint64_t>(g.kernel->param_bytes)) {
          fault(w, l, i.line,
                "read of byte " + std::to_string(static_cast<std::int64_t>(address[l])) + " of " +
                    std::to_string(g.kernel->param_bytes) + " bytes of parameters");
          good &= ~(1u << l);
        } else {
          at[l] = const_cast<char*>(g.params) + address[l];
        }
      }
      return good;
    }
    case Space::generic:
      break;
  }
  std::uint32_t in_shared = 0, in_local = 0, in_params = 0;
  const auto begin = [](const char* p) { return reinterpret_cast<std::uint64_t>(p); };
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    const std::uint64_t a = address[l];
    if (memory().inside(a)) continue;
    if (a - begin(g.shared) < static_cast<std::uint64_t>(g.shared_bytes)) {
      in_shared |= 1u << l;
      address[l] -= begin(g.shared);
    } else if (a - begin(g.local) < static_cast<std::uint64_t>(g.local_all)) {
      in_local |= 1u << l;
      if (a - begin(w.local[l]) >= static_cast<std::uint64_t>(g.kernel->local_bytes))
        fault(w, l, i.line, "access of local memory of another thread");
      address[l] -= begin(w.local[l]);
    } else if (a - begin(g.params) < static_cast<std::uint64_t>(g.kernel->param_bytes)) {
      in_params |= 1u << l;
      at[l] = reinterpret_cast<char*>(a);
    }
  }
  std::uint32_t good = in_params;
  if (in_shared) good |= shared_places(w, i, in_shared, address, at);
  if (in_local) good |= local_places(w, i, in_local, address, at);
  if (const std::uint32_t rest = mask & ~(in_shared | in_local | in_params))
    good |= global_places(w, i, rest, address, at);
  return good;
}

}  // namespace emulate
