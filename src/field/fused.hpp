// Element-wise operations on vectors that share a launch: on a device each launch costs microseconds, however short they are.
#pragma once

#include <algorithm>

#include "memory/array.hpp"

namespace softwet {

/// An operation body(i) for i = 0 .. count - 1.
template <class Body>
struct ForEach {
  int count;
  Body body;
};
template <class Body>
ForEach(int, Body) -> ForEach<Body>;

template <class... Parts>
struct FusedParts {
  KOKKOS_FORCEINLINE_FUNCTION void run(int, int) const {}
};
template <class First, class... Rest>
struct FusedParts<First, Rest...> {
  First first;
  FusedParts<Rest...> rest;

  KOKKOS_FORCEINLINE_FUNCTION void run(int begin, int end) const {
    const int last = end < first.count ? end : first.count;
    for (int i = begin; i < last; ++i) first.body(i);
    rest.run(begin, end);
  }
};

inline FusedParts<> fused_parts() { return {}; }
template <class First, class... Rest>
FusedParts<First, Rest...> fused_parts(const First& first, const Rest&... rest) {
  return {first, fused_parts(rest...)};
}

/// An item is a piece of the numbers i on the host, where the loops of the parts follow each other, and one i on a device.
template <class Parts>
struct Fused {
  static constexpr int piece = on_host ? 512 : 1;
  Parts parts;
  KOKKOS_FUNCTION void operator()(int item) const { parts.run(item * piece, (item + 1) * piece); }
};

/// Runs several operations as one kernel. For each i they follow each other; between different i there is no order, so no
/// operation may read what another one writes at another place.
template <class... Bodies>
void run_fused(const char* name, const ForEach<Bodies>&... parts) {
  using Kernel = Fused<FusedParts<ForEach<Bodies>...>>;
  const int count = std::max({parts.count...});
  if (count > 0)
    Kokkos::parallel_for(name, Items(0, (count + Kernel::piece - 1) / Kernel::piece), Kernel{fused_parts(parts...)});
}

struct Copy {
  Array to;
  ConstArray from;
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = from(i); }
};
/// As an operation of `run_fused`.
inline ForEach<Copy> copied(const Array& to, const ConstArray& from) {
  return {static_cast<int>(to.extent(0)), {to, from}};
}

}  // namespace softwet
