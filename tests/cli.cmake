# SPDX-License-Identifier: MIT
# The program scarp, from outside: what it prints, writes, accepts and refuses. One test per group
# of test_cli.py, and one per instruction set.

find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT TARGET scarp-cli)
  message(STATUS "The tests of the program scarp are left out: SCARP_BUILD_CLI is off")
elseif(NOT Python3_Interpreter_FOUND)
  message(STATUS "The tests of the program scarp are left out: no Python 3 found")
else()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)
  set(script ${CMAKE_CURRENT_LIST_DIR}/test_cli.py)
  foreach(group Commands Errors Files Pictures Compare Gallery Progress Threads)
    string(TOLOWER ${group} name)
    scarp_add_test(cli.${name} cli ${Python3_EXECUTABLE} ${script} ${group} ${program})
  endforeach()
  foreach(isa IN LISTS isas)
    scarp_add_test(cli.isa.${isa} cli ${Python3_EXECUTABLE} ${script} isa=${isa} ${program})
  endforeach()
endif()
