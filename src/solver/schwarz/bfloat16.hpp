// The upper half of single precision: 8 significant bits, and half of the memory to read.
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>
#include <cstring>

namespace softwet {

/// Rounded to nearest. What is not finite stays so.
KOKKOS_INLINE_FUNCTION std::uint16_t narrow(float x) {
  const auto bits = Kokkos::bit_cast<std::uint32_t>(x);
  if ((bits & 0x7f800000u) == 0x7f800000u) return 0x7fc0u;
  return static_cast<std::uint16_t>((bits + 0x7fffu + ((bits >> 16) & 1u)) >> 16);
}
KOKKOS_INLINE_FUNCTION float widen(std::uint16_t x) { return Kokkos::bit_cast<float>(std::uint32_t(x) << 16); }

/// Two that lie beside each other, the first at a multiple of four bytes. Machines here have the lower byte first.
struct TwoHalves {
  std::uint32_t both;

  TwoHalves() = default;
  explicit KOKKOS_FORCEINLINE_FUNCTION TwoHalves(const std::uint16_t* from) {
    std::memcpy(&both, __builtin_assume_aligned(from, 4), sizeof both);
  }
  KOKKOS_FORCEINLINE_FUNCTION float first() const { return Kokkos::bit_cast<float>(both << 16); }
  KOKKOS_FORCEINLINE_FUNCTION float second() const { return Kokkos::bit_cast<float>(both & 0xffff0000u); }
};

}  // namespace softwet
