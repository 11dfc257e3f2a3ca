# Writes generated/copyright, which packages hold: the licence of softwet, THIRD_PARTY.md, and the licence of each library that a program
# contains, as its source or its package in Debian has it.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE softwet_copyright)
file(READ ${PROJECT_SOURCE_DIR}/THIRD_PARTY.md softwet_third_party)
string(APPEND softwet_copyright "\n${softwet_third_party}")

# softwet_licence(NAME SOURCE PACKAGE): appends the licences of the library, from the FetchContent SOURCE or from the PACKAGE of Debian.
function(softwet_licence name source package)
  FetchContent_GetProperties(${source})
  set(files)
  if(${source}_POPULATED)
    file(GLOB files ${${source}_SOURCE_DIR}/LICEN[CS]E* ${${source}_SOURCE_DIR}/COPYING*)
    list(FILTER files EXCLUDE REGEX "GPL|APACHE|MINPACK|README")  # Eigen: of files that softwet does not include
  elseif(EXISTS /usr/share/doc/${package}/copyright)
    set(files /usr/share/doc/${package}/copyright)
  endif()
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(APPEND softwet_copyright "\n# Licence of ${name}\n\n${text}")
  endforeach()
  set(softwet_copyright "${softwet_copyright}" PARENT_SCOPE)
endfunction()

softwet_licence(Kokkos kokkos libkokkos-dev)
softwet_licence(Eigen eigen libeigen3-dev)
softwet_licence(toml++ tomlplusplus libtomlplusplus-dev)
softwet_licence(CLI11 cli11 libcli11-dev)
softwet_licence(fmt fmt libfmt-dev)
softwet_licence(muParser muparser libmuparser-dev)
softwet_licence(HDF5 hdf5 libhdf5-dev)
file(WRITE ${PROJECT_BINARY_DIR}/generated/copyright "${softwet_copyright}")
