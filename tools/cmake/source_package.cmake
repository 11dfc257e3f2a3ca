# Run by cpack: puts the committed sources into the archive of the sources. The other packages take what is installed.
if(CPACK_INSTALL_CMAKE_PROJECTS)
  return()
endif()
execute_process(COMMAND git -C ${CPACK_SOFTWET_SOURCES} archive HEAD
  COMMAND ${CMAKE_COMMAND} -E chdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_COMMAND} -E tar x /dev/stdin
  RESULTS_VARIABLE results)
if(NOT results STREQUAL "0;0")
  message(FATAL_ERROR "softwet: git could not archive ${CPACK_SOFTWET_SOURCES}; an archive of the sources is made from a "
    "git repository")
endif()
