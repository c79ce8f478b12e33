# SPDX-License-Identifier: MIT
# The program scarp, from outside: what it prints, writes, accepts and refuses. One test per class
# of cli/test_*.py, and one per instruction set.

find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT TARGET scarp-cli)
  message(STATUS "The tests of the program scarp are left out: SCARP_BUILD_CLI is off")
elseif(NOT Python3_Interpreter_FOUND)
  message(STATUS "The tests of the program scarp are left out: no Python 3 found")
else()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)

  # scarp_add_cli_test(FILE CLASS NAME): CLASS of cli/test_FILE.py as the test cli.NAME
  function(scarp_add_cli_test file class name)
    scarp_add_test(cli.${name} cli ${Python3_EXECUTABLE}
                   ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/cli/test_${file}.py ${class} ${program})
    set_tests_properties(cli.${name} PROPERTIES ENVIRONMENT
                         "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1")
  endfunction()

  foreach(test commands:Commands options:Errors formats:Formats formats:Names layers:Layers
               pictures:Pictures compare:Compare gallery:Gallery documents:Documents tiles:Tiles tiles:Resume
               world:Manifest world:Patterns world:Shares world:PowerCut world:Limits
               presets:Presets files:Files shared:Shared failures:FullDisk failures:Pipes failures:Refused
               interrupt:Interrupt
               progress:Progress memory:Memory same:Threads)
    string(REPLACE ":" ";" test ${test})
    list(GET test 0 file)
    list(GET test 1 class)
    string(TOLOWER ${class} name)
    scarp_add_cli_test(${file} ${class} ${name})
  endforeach()
  # The race detector looks at what threads do.
  set_tests_properties(cli.threads cli.interrupt PROPERTIES LABELS "cli;threads")
  foreach(isa IN LISTS isas)
    scarp_add_cli_test(same isa=${isa} isa.${isa})
  endforeach()
endif()

if(TARGET scarp-cli AND UNIX)
  scarp_test_program(test_interrupt SOURCES ${PROJECT_SOURCE_DIR}/src/cli/interrupt.c)
  target_compile_definitions(test_interrupt PRIVATE _XOPEN_SOURCE=700)
  scarp_add_test(cli.late_signal cli ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:test_interrupt>)
endif()

find_package(Threads QUIET)
if(TARGET scarp-cli AND CMAKE_USE_PTHREADS_INIT AND UNIX)
  scarp_test_program(test_crew)
  target_compile_definitions(test_crew PRIVATE SCARP_CLI_THREADS)
  target_link_libraries(test_crew PRIVATE Threads::Threads)
  scarp_add_test(cli.crew threads test_crew)
endif()
