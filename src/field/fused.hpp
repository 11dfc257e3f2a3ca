// Operations and kernels that share a launch: on a device each launch costs microseconds, however short they are.
#pragma once

#include <algorithm>
#include <type_traits>

#include "memory/chunk.hpp"

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

/// An item is a chunk of the numbers i, in which the loops of the parts follow each other.
template <class Parts>
struct Fused {
  static constexpr int piece = chunk(512);
  Parts parts;
  KOKKOS_FUNCTION void operator()(int item) const { parts.run(item * piece, (item + 1) * piece); }
};

/// A kernel for the items 0 .. items - 1.
template <class Kernel>
struct Counted {
  int items = 0;
  Kernel kernel = {};
};

template <class Kernel>
void run(const char* name, const Counted<Kernel>& kernel) {
  if (kernel.items > 0) Kokkos::parallel_for(name, Items(0, kernel.items), kernel.kernel);
}

/// Several operations as one kernel. For each i they follow each other; between different i there is no order, so no
/// operation may read what another one writes at another place.
template <class... Bodies>
using FusedKernel = Fused<FusedParts<ForEach<Bodies>...>>;
template <class... Bodies>
Counted<FusedKernel<Bodies...>> fused(const ForEach<Bodies>&... parts) {
  constexpr int piece = FusedKernel<Bodies...>::piece;
  return {chunks_in(std::max({parts.count...}), piece), {fused_parts(parts...)}};
}
template <class... Bodies>
void run_fused(const char* name, const ForEach<Bodies>&... parts) {
  run(name, fused(parts...));
}

/// Does nothing, in the place of a kernel or of an operation.
struct Nothing {
  KOKKOS_FUNCTION void operator()(int) const {}
};

/// A kernel that runs the items of one kernel, followed by the items of another.
template <class First, class Second>
struct InTurn {
  Counted<First> first;
  Counted<Second> second;
  KOKKOS_FUNCTION void operator()(int item) const {
    if (item < first.items) {
      first.kernel(item);
    } else {
      second.kernel(item - first.items);
    }
  }
};

/// Runs two kernels, on a device as one: there is no order between them, so neither may read what the other one writes.
/// On a processor threads would have unlike shares of them, and a launch costs little.
template <class First, class Second>
void run_beside(const char* name, const Counted<First>& first, const Counted<Second>& second) {
  if constexpr (host_algorithms || std::is_same_v<Second, Nothing>) {
    run(name, first);
    run(name, second);
  } else {
    run(name, Counted<InTurn<First, Second>>{first.items + second.items, {first, second}});
  }
}

struct Copy {
  Array to;
  ConstArray from;
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = from(i); }
};
/// A copy as an operation of `run_fused`.
inline ForEach<Copy> copied(const Array& to, const ConstArray& from) {
  return {static_cast<int>(to.extent(0)), {to, from}};
}

}  // namespace softwet
