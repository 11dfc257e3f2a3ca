# Provides Kokkos::kokkos: the pinned release built in this tree, or an installed one.
# FETCHCONTENT_SOURCE_DIR_KOKKOS=<unpacked source> works as always.

# Says at configure time what the program will run on, and keeps the architecture as softwet_arch.
macro(softwet_report_kokkos origin devices arch)
  list(JOIN ${devices} ", " softwet_devices)
  list(JOIN ${arch} ", " softwet_arch)
  if(NOT softwet_arch)
    set(softwet_arch "generic")
  endif()
  message(STATUS "softwet: Kokkos ${origin}, backends ${softwet_devices}, architecture ${softwet_arch}")
endmacro()

if(SOFTWET_SYSTEM_KOKKOS)
  find_package(Kokkos 5.0 REQUIRED)
  softwet_report_kokkos("${Kokkos_VERSION} of this site (${Kokkos_DIR})" Kokkos_DEVICES Kokkos_ARCH)
  return()
endif()

set(softwet_kokkos_version 5.0.2)
set(softwet_kokkos_sha256 188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e)

option(Kokkos_ENABLE_SERIAL "Serial back end" ON)
option(Kokkos_ENABLE_OPENMP "OpenMP back end" ON)
if(Kokkos_ENABLE_CUDA)
  option(Kokkos_ENABLE_CUDA_CONSTEXPR "Constexpr functions of the standard library on the device" ON)
endif()

# On a CPU, the instruction set: SOFTWET_ARCH where it is given, else a Kokkos_ARCH_* that was named, else that of this
# machine.
if(SOFTWET_ARCH)
  if(SOFTWET_ARCH STREQUAL "x86-64-v3")
    set(KOKKOS_ARCH_AVX2 ON)  # the width of Kokkos::Experimental::simd
  elseif(SOFTWET_ARCH STREQUAL "x86-64-v4")
    set(KOKKOS_ARCH_AVX512XEON ON)
  else()
    message(FATAL_ERROR "softwet: SOFTWET_ARCH is '${SOFTWET_ARCH}'; write x86-64-v3 (AVX2) or x86-64-v4 (AVX-512), "
      "or leave it empty to build for the processor of this machine")
  endif()
  set(Kokkos_ARCH_NATIVE OFF CACHE BOOL "Instruction set of this machine" FORCE)
elseif(NOT Kokkos_ENABLE_CUDA AND NOT Kokkos_ENABLE_HIP AND NOT Kokkos_ENABLE_SYCL)
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
if(POLICY CMP0169)
  cmake_policy(SET CMP0169 OLD)  # FetchContent_MakeAvailable of CMake 3.25 cannot leave out what Kokkos installs
endif()
FetchContent_Declare(kokkos URL ${softwet_kokkos_url} URL_HASH SHA256=${softwet_kokkos_sha256})
FetchContent_GetProperties(kokkos)
if(NOT kokkos_POPULATED)
  FetchContent_Populate(kokkos)
endif()
add_subdirectory(${kokkos_SOURCE_DIR} ${kokkos_BINARY_DIR} EXCLUDE_FROM_ALL SYSTEM)
if(SOFTWET_UNITY GREATER 1)  # its sources are short: most of the time goes to its headers
  set_target_properties(kokkoscore PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${SOFTWET_UNITY})
endif()

get_directory_property(softwet_enabled_devices DIRECTORY ${kokkos_SOURCE_DIR} DEFINITION KOKKOS_ENABLED_DEVICES)
get_directory_property(softwet_enabled_arch DIRECTORY ${kokkos_SOURCE_DIR} DEFINITION KOKKOS_ENABLED_ARCH_LIST)
if(SOFTWET_ARCH)
  target_compile_options(kokkoscore PUBLIC -march=${SOFTWET_ARCH})  # of Kokkos and of all that uses it
  list(APPEND softwet_enabled_arch ${SOFTWET_ARCH})
endif()
softwet_report_kokkos(${softwet_kokkos_version} softwet_enabled_devices softwet_enabled_arch)
