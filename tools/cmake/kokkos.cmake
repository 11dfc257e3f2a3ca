# Provides Kokkos::kokkos: the pinned release built in this tree, or an installed one.
# FETCHCONTENT_SOURCE_DIR_KOKKOS=<unpacked source> works as always.
if(SOFTWET_SYSTEM_KOKKOS)
  find_package(Kokkos 5.0 REQUIRED)
  return()
endif()

set(softwet_kokkos_version 5.0.2)
set(softwet_kokkos_sha256 188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e)

option(Kokkos_ENABLE_SERIAL "Serial back end" ON)
option(Kokkos_ENABLE_OPENMP "OpenMP back end" ON)
if(Kokkos_ENABLE_CUDA)
  option(Kokkos_ENABLE_CUDA_CONSTEXPR "Constexpr functions of the standard library on the device" ON)
endif()

# On a CPU build for the machine at hand, unless an architecture was named.
if(NOT Kokkos_ENABLE_CUDA AND NOT Kokkos_ENABLE_HIP AND NOT Kokkos_ENABLE_SYCL)
  set(softwet_arch_named FALSE)
  get_cmake_property(softwet_cache CACHE_VARIABLES)
  foreach(variable IN LISTS softwet_cache)
    if(variable MATCHES "^Kokkos_ARCH_" AND (${variable} OR variable STREQUAL "Kokkos_ARCH_NATIVE"))
      set(softwet_arch_named TRUE)
    endif()
  endforeach()
  if(NOT softwet_arch_named)
    set(Kokkos_ARCH_NATIVE ON CACHE BOOL "Instruction set of this machine")
  endif()
endif()

if(SOFTWET_KOKKOS_TARBALL)
  set(softwet_kokkos_url ${SOFTWET_KOKKOS_TARBALL})
else()
  set(softwet_kokkos_url
    https://github.com/kokkos/kokkos/releases/download/${softwet_kokkos_version}/kokkos-${softwet_kokkos_version}.tar.gz)
endif()

include(FetchContent)
FetchContent_Declare(kokkos SYSTEM URL ${softwet_kokkos_url} URL_HASH SHA256=${softwet_kokkos_sha256})
FetchContent_MakeAvailable(kokkos)
