// Small numbers packed into one constant.
//
// A value that is known when the program is compiled must not cost a device anything. A constexpr function with a loop
// does: where its argument is not a constant of the language, a device runs the loop, for each field of each point. So
// such values are packed, and a kernel reads them by a shift, which a compiler folds.
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace softwet {

/// Up to 16 numbers below 16, four bits each. No class: a device knows no address of a constant of the host.
using Packed = std::uint64_t;

/// number(0), ..., number(count - 1).
template <int count, class Number>
constexpr Packed packed(const Number& number) {
  static_assert(count <= 16);
  Packed all = 0;
  for (int i = 0; i < count; ++i) {
    if (number(i) < 0 || number(i) > 15) throw "no packed number may be above 15";  // ends the compilation
    all |= static_cast<Packed>(number(i)) << (4 * i);
  }
  return all;
}

KOKKOS_FORCEINLINE_FUNCTION constexpr int unpacked(Packed all, int i) { return static_cast<int>(all >> (4 * i)) & 15; }

}  // namespace softwet
