# SPDX-License-Identifier: MIT
# Tests the program scarp from outside: what it prints, writes, accepts and refuses. One test per
# class of cli/test_*.py, and one per instruction set.

block()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)

  # scarp_add_cli_test(FILE CLASS NAME [tool...]): CLASS of cli/test_FILE.py as the test cli.NAME
  function(scarp_add_cli_test file class name)
    scarp_add_test(cli.${name} cli NEEDS scarp python3 ${ARGN} COMMAND ${Python3_EXECUTABLE}
                   ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/cli/test_${file}.py ${class} ${program})
    if(TEST cli.${name})
      set_tests_properties(cli.${name} PROPERTIES ENVIRONMENT
                           "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1;SCARP_MANUAL=${CMAKE_BINARY_DIR}/src/cli/scarp.1")
    endif()
  endfunction()

  # What these look at is not there on Windows: signals and limits of POSIX, symbolic links,
  # permissions, terminals.
  set(posix_classes FullDisk Pipes Closed Interrupt Progress Memory Shared Gdal)
  foreach(test commands:Commands options:Errors formats:Formats formats:Names layers:Layers relief:Relief relief:Palettes sheet:Sheet
               pictures:Pictures compare:Compare recipe:Recipes recipe:RecipesRefused recipe:Command gallery:Gallery shown:Shown period:Period phase:Phase phase:Flow phase:PhaseRefused documents:Documents tiles:Tiles tiles:Resume
               world:Manifest world:Patterns world:Shares world:Limits
               files:Files shared:Shared failures:FullDisk failures:Pipes failures:Refused
               failures:Closed interrupt:Interrupt outputs:Fields outputs:Masks outputs:Slopes levels:Levels
               tiff:Tiff tiff:Systems tiff:Gdal verify:Verify verify:Space
               progress:Progress memory:Memory same:Threads view:View view:ViewRefused golden:Golden)
    string(REPLACE ":" ";" test ${test})
    list(GET test 0 file)
    list(GET test 1 class)
    string(TOLOWER ${class} name)
    set(tools)
    if(class IN_LIST posix_classes)
      set(tools posix)
    endif()
    scarp_add_cli_test(${file} ${class} ${name} ${tools})
  endforeach()
  if(WIN32)
    scarp_add_cli_test(windows Windows windows)
    scarp_test_program(test_windows_paths SOURCES
                       ${PROJECT_SOURCE_DIR}/src/cli/shared/windows_files.c)
    target_include_directories(test_windows_paths PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
    scarp_add_test(cli.paths cli COMMAND test_windows_paths)
  endif()
  # ThreadSanitizer runs the tests with this label.
  foreach(name cli.threads cli.interrupt)
    if(TEST ${name})
      set_property(TEST ${name} APPEND PROPERTY LABELS threads)
    endif()
  endforeach()
  foreach(isa IN LISTS isas)
    scarp_add_cli_test(same isa=${isa} isa.${isa})
  endforeach()
  scarp_add_cli_test(faults PowerCut powercut strace)
  scarp_add_cli_test(faults Faults faults strace)
  scarp_add_cli_test(documents Roff roff groff)
  scarp_add_cli_test(documents Completion completion bash)
endblock()

# What says many refusals in one process
if(TARGET scarp-cli-parts)
  add_executable(test_cli_refused cli/refused.c)
  scarp_compile_rules(test_cli_refused)
  target_link_libraries(test_cli_refused PRIVATE scarp-cli-parts)
endif()

if("scarp" IN_LIST scarp_found)
  set(shared ${PROJECT_SOURCE_DIR}/src/cli/shared)
  scarp_test_program(test_cli_words SOURCES ${shared}/amount.c ${shared}/noise_options.c ${shared}/number.c ${shared}/options.c
                     ${shared}/options_words.c ${shared}/text.c ${shared}/values.c)
  target_include_directories(test_cli_words PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
endif()
scarp_add_test(cli.words cli NEEDS scarp COMMAND test_cli_words)

if("scarp" IN_LIST scarp_found)
  scarp_test_program(test_progress)
  target_include_directories(test_progress PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_progress PRIVATE _XOPEN_SOURCE=700)
  if(WIN32)
    target_sources(test_progress PRIVATE ${shared}/windows_files.c ${shared}/windows_system.c)
    target_link_libraries(test_progress PRIVATE shell32)
  endif()
endif()
scarp_add_test(cli.time_left cli NEEDS scarp COMMAND test_progress
               ${CMAKE_CURRENT_BINARY_DIR}/progress.txt)

if("scarp" IN_LIST scarp_found)
  set(cli ${PROJECT_SOURCE_DIR}/src/cli)
  scarp_test_program(test_view_march SOURCES ${cli}/ground/ground.c ${cli}/ground/spread.c
                     ${cli}/shared/error.c
                     ${cli}/shared/interrupt.c ${cli}/shared/sine.c ${cli}/view/camera.c
                     ${cli}/view/march.c ${cli}/view/scene.c)
  target_include_directories(test_view_march PRIVATE ${cli})
  target_compile_definitions(test_view_march PRIVATE _XOPEN_SOURCE=700)
endif()
scarp_add_test(cli.view_march cli NEEDS scarp COMMAND test_view_march)

if(UNIX)
  scarp_test_program(test_interrupt SOURCES ${PROJECT_SOURCE_DIR}/src/cli/shared/interrupt.c)
  target_include_directories(test_interrupt PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_interrupt PRIVATE _XOPEN_SOURCE=700)
endif()
if(UNIX AND "pthreads" IN_LIST scarp_found)
  scarp_test_program(test_crew)
  target_include_directories(test_crew PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_crew PRIVATE SCARP_CLI_THREADS)
  target_link_libraries(test_crew PRIVATE Threads::Threads)
endif()
scarp_add_test(cli.crew threads NEEDS posix pthreads COMMAND test_crew)
scarp_add_test(cli.late_signal cli NEEDS posix COMMAND test_interrupt)
