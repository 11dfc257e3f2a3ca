# What a package may hold or ask for: softwet_package_libraries(RESULT PROGRAM) gives the libraries that PROGRAM calls, directly and through
# others, less the C library's, and ends where one is not in the list. As a script: cmake -DPROGRAM=... -P package_libraries.cmake
set(softwet_c_library "^lib(c|m|mvec|pthread|dl|rt|resolv|util)[.]so" "^ld-linux")
set(softwet_allowed "^lib(fmt|muparser|gomp|omp|stdc[+][+]|gcc_s)[-.]")

function(softwet_package_libraries result program)
  file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}" RESOLVED_DEPENDENCIES_VAR libraries UNRESOLVED_DEPENDENCIES_VAR lost
    PRE_EXCLUDE_REGEXES ${softwet_c_library})
  set(refused)
  foreach(library IN LISTS libraries lost)
    get_filename_component(name "${library}" NAME)
    if(NOT name MATCHES "${softwet_allowed}")
      list(APPEND refused "${name}")
    endif()
  endforeach()
  if(refused)
    list(JOIN refused " " refused)
    message(FATAL_ERROR "softwet: a package would need libraries that softwet does not call or that are not in THIRD_PARTY.md: ${refused}. "
      "HDF5 brings most of them: packages are built with -DSOFTWET_OWN_HDF5=ON, as the preset portable is.")
  endif()
  set(${result} "${libraries}" PARENT_SCOPE)
endfunction()

if(PROGRAM)
  softwet_package_libraries(libraries "${PROGRAM}")
endif()
