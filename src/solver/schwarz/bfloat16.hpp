// The upper half of single precision: 8 significant bits, and half of the memory to read.
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace softwet {

/// Rounded to nearest. What is not finite stays so.
KOKKOS_INLINE_FUNCTION std::uint16_t narrow(float x) {
  const auto bits = Kokkos::bit_cast<std::uint32_t>(x);
  if ((bits & 0x7f800000u) == 0x7f800000u) return 0x7fc0u;
  return static_cast<std::uint16_t>((bits + 0x7fffu + ((bits >> 16) & 1u)) >> 16);
}
KOKKOS_INLINE_FUNCTION float widen(std::uint16_t x) { return Kokkos::bit_cast<float>(std::uint32_t(x) << 16); }

}  // namespace softwet
