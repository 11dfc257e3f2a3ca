# SOFTWET_VERSION and SOFTWET_COMMIT of the sources in SOURCE_DIR. As a script it also writes OUTPUT from INPUT with them; an
# unchanged file is left alone.
#   at the tag v0.2.0: 0.2.0; five commits later: 0.2.0+5; without a tag: PROJECT_VERSION
#   in an archive made by git, which has no repository: what git wrote into archive.txt beside this file

function(softwet_git result)
  execute_process(COMMAND git -C ${SOURCE_DIR} ${ARGN}
    OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(text "")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(softwet_tag "")
set(SOFTWET_COMMIT unknown)
softwet_git(softwet_top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE_DIR} softwet_here)
if(softwet_top STREQUAL softwet_here)  # not the repository of a folder above, into which an archive was unpacked
  softwet_git(softwet_tag describe --tags "--match=v[0-9]*")
  softwet_git(SOFTWET_COMMIT describe --always --dirty --abbrev=12 --exclude=*)
else()
  file(READ ${CMAKE_CURRENT_LIST_DIR}/archive.txt softwet_archive)
  if(softwet_archive MATCHES "tag: (v[0-9][^\n]*)")
    set(softwet_tag ${CMAKE_MATCH_1})
  endif()
  if(softwet_archive MATCHES "commit: ([0-9a-f]+)")
    string(SUBSTRING ${CMAKE_MATCH_1} 0 12 SOFTWET_COMMIT)
  endif()
endif()

set(SOFTWET_VERSION ${PROJECT_VERSION})
if(softwet_tag MATCHES "^v(.+)-([0-9]+)-g[0-9a-f]+$")
  set(SOFTWET_VERSION ${CMAKE_MATCH_1}+${CMAKE_MATCH_2})
elseif(softwet_tag MATCHES "^v(.+)$")
  set(SOFTWET_VERSION ${CMAKE_MATCH_1})
endif()

if(INPUT)
  configure_file(${INPUT} ${OUTPUT} @ONLY)
endif()
