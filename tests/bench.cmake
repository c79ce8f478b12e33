# SPDX-License-Identifier: MIT
# The program scarp-bench, from outside: that it measures and tells, not how fast anything is.

find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT TARGET scarp-bench)
  message(STATUS "The tests of the program scarp-bench are left out: SCARP_BUILD_BENCH is off")
elseif(NOT Python3_Interpreter_FOUND)
  message(STATUS "The tests of the program scarp-bench are left out: no Python 3 found")
else()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-bench>)
  set(script ${CMAKE_CURRENT_LIST_DIR}/test_bench.py)
  foreach(group Selection Results Errors)
    string(TOLOWER ${group} name)
    scarp_add_test(bench.${name} bench ${Python3_EXECUTABLE} ${script} ${group} ${program})
  endforeach()
endif()
