// SIMD packs of single and double precision on the host, in every build: on one with a device the default packs are scalars.
#pragma once

#include <Kokkos_SIMD.hpp>

namespace softwet {

#if defined(KOKKOS_ARCH_AVX512XEON)
template <class Number>
using HostPack =
    Kokkos::Experimental::basic_simd<Number, Kokkos::Experimental::simd_abi::avx512_fixed_size<64 / sizeof(Number)>>;
inline constexpr int host_registers = 32;
#elif defined(KOKKOS_ARCH_AVX2)
template <class Number>
using HostPack =
    Kokkos::Experimental::basic_simd<Number, Kokkos::Experimental::simd_abi::avx2_fixed_size<32 / sizeof(Number)>>;
inline constexpr int host_registers = 16;
#else
template <class Number>
using HostPack = Kokkos::Experimental::simd<Number>;
inline constexpr int host_registers = 16;
#endif
template <class Number>
inline constexpr int host_lanes = static_cast<int>(HostPack<Number>::size());

template <class Number>
HostPack<Number> load(const Number* from) {
  return Kokkos::Experimental::simd_unchecked_load<HostPack<Number>>(from, Kokkos::Experimental::simd_flag_default);
}
template <class Number>
void store(const HostPack<Number>& x, Number* to) {
  Kokkos::Experimental::simd_unchecked_store(x, to, Kokkos::Experimental::simd_flag_default);
}

}  // namespace softwet
