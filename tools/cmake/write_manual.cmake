# Run by cmake --install: softwet_program writes its manual page and its completion into softwet_generated. Where it does
# not run (built for another processor), both are left out.
function(softwet_write file)
  execute_process(COMMAND ${softwet_program} ${ARGN} OUTPUT_FILE ${softwet_generated}/${file} RESULT_VARIABLE failed)
  if(failed)
    message(WARNING "softwet: ${softwet_program} does not run on this machine; ${file} is not installed")
    file(REMOVE ${softwet_generated}/${file})
  endif()
endfunction()

softwet_write(softwet.1 man)
softwet_write(softwet.bash completion bash)
