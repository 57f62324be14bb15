# Runs PROGRAM and compares its standard output with the committed file EXPECTED, to the byte.
#     cmake -D PROGRAM=... -D EXPECTED=... -D WORK=... -P same_output.cmake
execute_process(COMMAND ${PROGRAM} OUTPUT_FILE ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK} ${EXPECTED}
    RESULT_VARIABLE different)
if(different)
    message(FATAL_ERROR "${EXPECTED} is not what ${PROGRAM} writes")
endif()
