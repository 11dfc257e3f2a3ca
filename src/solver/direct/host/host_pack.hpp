// SIMD packs of single precision on the host, in every build: on one with a device the default packs are scalars.
#pragma once

#include <Kokkos_SIMD.hpp>

namespace softwet {

#if defined(KOKKOS_ARCH_AVX512XEON)
using HostPack = Kokkos::Experimental::basic_simd<float, Kokkos::Experimental::simd_abi::avx512_fixed_size<16>>;
#elif defined(KOKKOS_ARCH_AVX2)
using HostPack = Kokkos::Experimental::basic_simd<float, Kokkos::Experimental::simd_abi::avx2_fixed_size<8>>;
#else
using HostPack = Kokkos::Experimental::simd<float>;
#endif
inline constexpr int host_lanes = static_cast<int>(HostPack::size());

inline HostPack load(const float* from) {
  return Kokkos::Experimental::simd_unchecked_load<HostPack>(from, Kokkos::Experimental::simd_flag_default);
}
inline void store(const HostPack& x, float* to) {
  Kokkos::Experimental::simd_unchecked_store(x, to, Kokkos::Experimental::simd_flag_default);
}

}  // namespace softwet
