# What a Python wheel holds (pyproject.toml, scikit-build-core): the program with all libraries other than the C
# library, its tools and cases below softwet/program, and manual page and completion for the environment.
set_target_properties(softwet PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
target_link_options(softwet PRIVATE -Wl,--disable-new-dtags)  # the path holds for the libraries of the libraries too
install(TARGETS softwet RUNTIME DESTINATION bin)

# Each library once, by the name that others ask for: a wheel knows no links.
install(CODE "
  set(softwet_program \"$<TARGET_FILE:softwet>\")
  include(\"${PROJECT_SOURCE_DIR}/tools/cmake/package_libraries.cmake\")")
install(CODE [[
  set(folder "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib")
  file(MAKE_DIRECTORY "${folder}")
  softwet_package_libraries(libraries "${softwet_program}")
  foreach(library IN LISTS libraries)
    get_filename_component(name "${library}" NAME)
    file(REAL_PATH "${library}" file)
    file(COPY_FILE "${file}" "${folder}/${name}" ONLY_IF_DIFFERENT)
  endforeach()
]])
install(FILES LICENSE THIRD_PARTY.md ${PROJECT_BINARY_DIR}/generated/copyright DESTINATION .)
