# SPDX-License-Identifier: MIT
# Tests the essentials of scarp from outside, without Python: one test per script of cli/*.sh.

foreach(name commands errors formats interrupt tiles)
  set(without)
  if(name MATCHES "commands|errors") # what a machine without Python tests
    set(without without-python3)
  endif()
  scarp_add_test(cli.sh.${name} cli IN ${without} NOT s390x NEEDS posix scarp sh
                 COMMAND sh ${name}.sh $<TARGET_FILE:scarp-cli> ${CMAKE_CROSSCOMPILING_EMULATOR})
  set_tests_properties(cli.sh.${name} PROPERTIES
                       WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/cli)
endforeach()
