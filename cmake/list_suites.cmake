# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): asks the GoogleTest PROGRAM for its suites and writes OUTPUT, which
# tells CTest to run each of them; those of a COST before others.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listing
  COMMAND_ERROR_IS_FATAL ANY)
get_filename_component(folder ${OUTPUT} DIRECTORY)
get_filename_component(program ${PROGRAM} NAME)
# A suite begins a line and ends in a point; its tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listing}")
set(lines "")
if(COST)
  set(cost " COST ${COST}")
endif()
foreach(suite ${suites})
  string(REGEX REPLACE "^\n" "" suite "${suite}")
  string(APPEND lines "add_test([=[${program}: ${suite}*]=] ${PROGRAM} --gtest_filter=${suite}*)\n"
    "set_tests_properties([=[${program}: ${suite}*]=] PROPERTIES WORKING_DIRECTORY ${folder}${cost})\n")
endforeach()
file(WRITE ${OUTPUT} "${lines}")
