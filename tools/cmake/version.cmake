# Writes OUTPUT from INPUT with VERSION and the commit of SOURCE_DIR; an unchanged file is left alone.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE SOFTWET_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(SOFTWET_COMMIT unknown)
endif()
set(SOFTWET_VERSION ${VERSION})
configure_file(${INPUT} ${OUTPUT} @ONLY)
