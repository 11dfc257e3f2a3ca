# cpack: an archive and a Debian package of what cmake --install installs; target package_source: an archive of the sources.
set(SOURCE_DIR ${PROJECT_SOURCE_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/version.cmake)

if(softwet_arch STREQUAL "NATIVE")
  message(STATUS "softwet: cpack would make packages for processors like this one; for others take the preset portable")
endif()
string(REPLACE ", " "-" softwet_package_arch ${softwet_arch})
string(TOLOWER ${softwet_package_arch} softwet_package_arch)

set(CPACK_PACKAGE_NAME softwet)
set(CPACK_PACKAGE_VERSION ${SOFTWET_VERSION})
set(CPACK_PACKAGE_VENDOR "The softwet developers")
set(CPACK_PACKAGE_CONTACT "The softwet developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Droplets on soft solids: a diffuse-interface fluid coupled to an elastic substrate")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_FILE_NAME softwet-${SOFTWET_VERSION}-linux-${softwet_package_arch})
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR TGZ DEB)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "python3-numpy, python3-scipy, python3-h5py, python3-matplotlib, python3-pandas, man-db, bash-completion")

# The sources as committed: git fills in the version, and files that git does not know stay out.
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_INSTALLED_DIRECTORIES "")
set(CPACK_SOURCE_PACKAGE_FILE_NAME softwet-${SOFTWET_VERSION}-source)
set(CPACK_SOFTWET_SOURCES ${PROJECT_SOURCE_DIR})
set(CPACK_INSTALL_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/source_package.cmake)
include(CPack)
