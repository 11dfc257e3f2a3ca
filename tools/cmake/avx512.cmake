# SOFTWET_AVX512_BESIDE: the same program once more for AVX-512, as softwet-x86-64-v4 beside softwet, which starts it in its own place
# where the processor can (src/cli/processor.c). It compiles everything twice.
include(ExternalProject)
if(NOT SOFTWET_ARCH STREQUAL "x86-64-v3")
  message(FATAL_ERROR "softwet: SOFTWET_AVX512_BESIDE needs a program for AVX2: give -DSOFTWET_ARCH=x86-64-v3, as the preset portable does")
endif()

set(softwet_beside_options)
foreach(option CMAKE_BUILD_TYPE CMAKE_C_COMPILER CMAKE_CXX_COMPILER CMAKE_CXX_COMPILER_LAUNCHER
        SOFTWET_REDUCED_QUADRATURE SOFTWET_UNITY SOFTWET_FETCH SOFTWET_OWN_HDF5 Kokkos_ENABLE_SERIAL Kokkos_ENABLE_OPENMP)
  list(APPEND softwet_beside_options -D${option}=${${option}})
endforeach()
foreach(library hdf5 tomlplusplus cli11 fmt muparser eigen)  # sources that are here already
  FetchContent_GetProperties(${library})
  if(${library}_POPULATED)
    string(TOUPPER ${library} name)
    list(APPEND softwet_beside_options -DFETCHCONTENT_SOURCE_DIR_${name}=${${library}_SOURCE_DIR})
  endif()
endforeach()
list(JOIN SOFTWET_CONFIGURATIONS "|" softwet_beside_configurations)
if(SKBUILD)  # the libraries of a wheel
  list(APPEND softwet_beside_options -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON "-DCMAKE_INSTALL_RPATH=$ORIGIN/../lib"
    -DCMAKE_EXE_LINKER_FLAGS=-Wl,--disable-new-dtags)
endif()
ExternalProject_Add(softwet_avx512
  SOURCE_DIR ${PROJECT_SOURCE_DIR} BINARY_DIR ${PROJECT_BINARY_DIR}/avx512 PREFIX ${PROJECT_BINARY_DIR}/avx512
  LIST_SEPARATOR "|"
  CMAKE_ARGS ${softwet_beside_options} -DSOFTWET_CONFIGURATIONS=${softwet_beside_configurations} -DSOFTWET_ARCH=x86-64-v4
    -DSOFTWET_BUILD_TESTS=OFF -DFETCHCONTENT_SOURCE_DIR_KOKKOS=${kokkos_SOURCE_DIR}
  BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target softwet
  BUILD_ALWAYS ON USES_TERMINAL_BUILD ON
  INSTALL_COMMAND ${CMAKE_COMMAND} -E copy_if_different <BINARY_DIR>/softwet ${PROJECT_BINARY_DIR}/softwet-x86-64-v4
  BUILD_BYPRODUCTS ${PROJECT_BINARY_DIR}/softwet-x86-64-v4)
add_dependencies(softwet_avx512 kokkoscore)  # whose sources both take
add_dependencies(softwet softwet_avx512)
install(PROGRAMS ${PROJECT_BINARY_DIR}/softwet-x86-64-v4 DESTINATION bin)
