# cmake --install: the program, its tools, cases, manual and documentation. Every path is relative to the prefix, and the
# program finds its tools beside itself, so that the folder can be moved.
set(softwet_share share/softwet)
include(tools/cmake/licences.cmake)

if(SKBUILD)
  include(tools/cmake/wheel.cmake)
  set(softwet_manual ${SKBUILD_DATA_DIR}/share)  # of the environment into which the wheel is installed
else()
  install(TARGETS softwet RUNTIME DESTINATION bin)
  set(softwet_manual share)
  if(SOFTWET_OWN_HDF5 AND NOT SOFTWET_MPI AND NOT SOFTWET_SYSTEM_KOKKOS AND NOT Kokkos_ENABLE_CUDA AND NOT Kokkos_ENABLE_HIP)  # for a package
    install(CODE "
      include(\"${PROJECT_SOURCE_DIR}/tools/cmake/package_libraries.cmake\")
      softwet_package_libraries(libraries \"$<TARGET_FILE:softwet>\")")
  endif()
endif()

# Tools that need the sources stay with them.
install(DIRECTORY tools/ DESTINATION ${softwet_share}/tools USE_SOURCE_PERMISSIONS
  PATTERN setup EXCLUDE PATTERN setup.py EXCLUDE PATTERN pyproject.toml EXCLUDE PATTERN run EXCLUDE PATTERN rooms EXCLUDE
  PATTERN test EXCLUDE PATTERN bench EXCLUDE PATTERN fuzz EXCLUDE PATTERN gallery EXCLUDE PATTERN site_links.py EXCLUDE
  PATTERN cmake EXCLUDE PATTERN packaging EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY cases/ DESTINATION ${softwet_share}/cases)

# The studies of `softwet verify`, where tools/verify looks for them.
install(DIRECTORY tests/verification tests/oracle DESTINATION ${softwet_share}/tests
  FILES_MATCHING PATTERN *.py PATTERN mms EXCLUDE PATTERN time_order.py EXCLUDE)

# The package softwet of tools/, where Debian's python3 looks for packages.
if(NOT SKBUILD)
  install(CODE [[
    set(packages "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages")
    file(MAKE_DIRECTORY "${packages}")
    file(CREATE_LINK ../../../share/softwet/tools/softwet "${packages}/softwet" SYMBOLIC)
  ]])
endif()

# Manual and completion, written by the program itself.
set(softwet_generated ${PROJECT_BINARY_DIR}/generated)
install(CODE "
  set(softwet_program \"$<TARGET_FILE:softwet>\")
  set(softwet_generated \"${softwet_generated}\")")
install(SCRIPT tools/cmake/write_manual.cmake)
install(FILES ${softwet_generated}/softwet.1 DESTINATION ${softwet_manual}/man/man1 OPTIONAL)
install(FILES ${softwet_generated}/softwet.bash DESTINATION ${softwet_manual}/bash-completion/completions RENAME softwet OPTIONAL)

if(SKBUILD)
  return()
endif()
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE THIRD_PARTY.md DESTINATION share/doc/softwet)
install(DIRECTORY docs DESTINATION share/doc/softwet)
# module use PREFIX/share/softwet/modulefiles
configure_file(tools/packaging/modulefile.in ${PROJECT_BINARY_DIR}/generated/modulefile @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/modulefile DESTINATION ${softwet_share}/modulefiles/softwet RENAME ${PROJECT_VERSION})
install(FILES ${PROJECT_BINARY_DIR}/generated/copyright DESTINATION share/doc/softwet)
