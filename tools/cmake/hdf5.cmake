# SOFTWET_OWN_HDF5: provides HDF5::HDF5 as a static library of the C interface alone, which needs nothing but the C library: no filters
# (softwet compresses nothing), no network drivers, no MPI. So a package holds no library that softwet does not call.
# FETCHCONTENT_SOURCE_DIR_HDF5=<unpacked source> takes another source.
include(ExternalProject)
set(SOFTWET_HDF5_TARBALL "" CACHE FILEPATH "Local copy of the HDF5 source, as tools/setup fetches it; empty: download the release")
if(SOFTWET_HDF5_TARBALL)
  FetchContent_Declare(hdf5 URL ${SOFTWET_HDF5_TARBALL} SOURCE_SUBDIR none
    URL_HASH SHA256=71cdb04c151ef4e8a7f88907adfc4f3b75afd44e96fbd55775e1c9d7c4e7c112)
else()
  FetchContent_Declare(hdf5 GIT_REPOSITORY https://github.com/HDFGroup/hdf5.git GIT_TAG hdf5_1.14.5 GIT_SHALLOW ON SOURCE_SUBDIR none)
endif()
FetchContent_MakeAvailable(hdf5)

set(softwet_hdf5_prefix ${PROJECT_BINARY_DIR}/hdf5)
set(softwet_hdf5_library ${softwet_hdf5_prefix}/lib/libhdf5.a)
set(softwet_hdf5_options -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=${softwet_hdf5_prefix} -DHDF5_INSTALL_LIB_DIR=lib
  -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER} -DCMAKE_C_FLAGS=-w -DCMAKE_POSITION_INDEPENDENT_CODE=ON)
foreach(off BUILD_SHARED_LIBS BUILD_TESTING HDF5_BUILD_TOOLS HDF5_BUILD_UTILS HDF5_BUILD_EXAMPLES HDF5_BUILD_HL_LIB HDF5_BUILD_CPP_LIB HDF5_BUILD_FORTRAN
    HDF5_BUILD_JAVA HDF5_ENABLE_Z_LIB_SUPPORT HDF5_ENABLE_SZIP_SUPPORT HDF5_ENABLE_PLUGIN_SUPPORT HDF5_ENABLE_ROS3_VFD HDF5_ENABLE_HDFS
    HDF5_ENABLE_PARALLEL HDF5_ENABLE_THREADSAFE HDF5_ENABLE_EMBEDDED_LIBINFO HDF5_ENABLE_NONSTANDARD_FEATURES)
  list(APPEND softwet_hdf5_options -D${off}=OFF)
endforeach()
ExternalProject_Add(softwet_hdf5
  SOURCE_DIR ${hdf5_SOURCE_DIR} BINARY_DIR ${PROJECT_BINARY_DIR}/hdf5-build PREFIX ${PROJECT_BINARY_DIR}/hdf5-steps
  CMAKE_ARGS ${softwet_hdf5_options}
  LOG_CONFIGURE ON LOG_BUILD ON LOG_INSTALL ON LOG_OUTPUT_ON_FAILURE ON
  BUILD_BYPRODUCTS ${softwet_hdf5_library})

file(MAKE_DIRECTORY ${softwet_hdf5_prefix}/include)
add_library(HDF5::HDF5 STATIC IMPORTED)
set_target_properties(HDF5::HDF5 PROPERTIES IMPORTED_LOCATION ${softwet_hdf5_library}
  INTERFACE_INCLUDE_DIRECTORIES ${softwet_hdf5_prefix}/include INTERFACE_LINK_LIBRARIES "${CMAKE_DL_LIBS};m")
add_dependencies(HDF5::HDF5 softwet_hdf5)
message(STATUS "softwet: HDF5 of its own from ${hdf5_SOURCE_DIR}")
