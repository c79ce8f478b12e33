# SPDX-License-Identifier: MIT
# Tests the program scarp from outside: what it prints, writes, accepts and refuses. One test per
# class of cli/test_*.py, and one per instruction set.

block()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)

  # scarp_add_cli_test(FILE CLASS... [IN leg...] [NOT leg...] [NEEDS tool...]): each CLASS of
  # cli/test_FILE.py as the test cli.CLASS in lower case, but for the dot in isa=SET
  function(scarp_add_cli_test file)
    cmake_parse_arguments(arg "" "" "IN;NOT;NEEDS" ${ARGN})
    foreach(class IN LISTS arg_UNPARSED_ARGUMENTS)
      string(TOLOWER cli.${class} name)
      string(REPLACE "=" "." name ${name})
      scarp_add_test(${name} cli IN ${arg_IN} NOT ${arg_NOT} NEEDS scarp python3 ${arg_NEEDS}
                     COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/cli/test_${file}.py
                     ${class} ${program})
      if(TEST ${name})
        set_tests_properties(${name} PROPERTIES ENVIRONMENT
                             "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1;SCARP_MANUAL=${CMAKE_BINARY_DIR}/src/cli/scarp.1")
      endif()
    endforeach()
  endfunction()

  scarp_add_cli_test(commands Commands IN windows without-library)
  scarp_add_cli_test(options Errors NOT s390x sanitized)
  scarp_add_cli_test(formats Formats)
  scarp_add_cli_test(formats Names IN without-library NOT s390x)
  scarp_add_cli_test(layers Layers NOT s390x)
  scarp_add_cli_test(relief Relief Alike Palettes NOT s390x)
  scarp_add_cli_test(sheet Sheet NOT s390x)
  scarp_add_cli_test(pictures Pictures)
  scarp_add_cli_test(compare Compare NOT s390x)
  scarp_add_cli_test(recipe Recipes IN without-library NOT s390x)
  scarp_add_cli_test(recipe RecipesRefused NOT s390x)
  scarp_add_cli_test(recipe Command)
  scarp_add_cli_test(gallery Gallery IN thorough)
  scarp_add_cli_test(shown Shown IN without-gdal without-library NOT s390x sanitized)
  scarp_add_cli_test(period Period NOT s390x)
  scarp_add_cli_test(phase Phase Flow PhaseRefused NOT s390x)
  scarp_add_cli_test(documents Documents IN without-gdal without-groff without-library without-strace)
  scarp_add_cli_test(documents Roff IN without-groff NEEDS groff)
  scarp_add_cli_test(documents Completion IN without-bash NEEDS bash)
  scarp_add_cli_test(tiles Tiles)
  scarp_add_cli_test(tiles Resume IN ${long} NOT s390x)
  scarp_add_cli_test(world Manifest Shares Limits IN ${long} NOT s390x)
  scarp_add_cli_test(world Patterns)
  scarp_add_cli_test(files Files IN windows NOT s390x)
  scarp_add_cli_test(failures Refused IN windows)
  scarp_add_cli_test(faults PowerCut IN without-strace NEEDS strace)
  scarp_add_cli_test(faults Faults IN thorough NEEDS strace)
  scarp_add_cli_test(outputs Fields Masks IN without-library)
  scarp_add_cli_test(outputs Slopes)
  scarp_add_cli_test(levels Levels)
  scarp_add_cli_test(tiff Tiff IN without-library)
  scarp_add_cli_test(tiff Systems)
  scarp_add_cli_test(verify Verify Space IN windows)
  scarp_add_cli_test(same Threads IN threads ${long} NOT s390x)
  scarp_add_cli_test(view View IN musl NOT memory s390x)
  scarp_add_cli_test(view ViewRefused NOT memory s390x)
  scarp_add_cli_test(golden Golden IN musl windows windows-clang)
  foreach(isa IN LISTS isas)
    scarp_add_cli_test(same isa=${isa})
  endforeach()

  # What these look at is not there on Windows: signals and limits of POSIX, symbolic links,
  # permissions, terminals.
  scarp_add_cli_test(shared Shared NOT s390x NEEDS posix)
  scarp_add_cli_test(failures FullDisk Pipes NOT s390x NEEDS posix)
  scarp_add_cli_test(failures Closed IN without-strace NEEDS posix)
  scarp_add_cli_test(interrupt Interrupt IN threads thorough NEEDS posix)
  scarp_add_cli_test(tiff Gdal IN thorough NEEDS posix)
  scarp_add_cli_test(progress Progress IN without-library NOT s390x NEEDS posix)
  scarp_add_cli_test(memory Memory IN thorough NEEDS posix)
  if(WIN32)
    scarp_add_cli_test(windows Windows IN windows)
    scarp_test_program(test_windows_paths SOURCES
                       ${PROJECT_SOURCE_DIR}/src/cli/shared/windows_files.c)
    target_include_directories(test_windows_paths PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
    scarp_add_test(cli.paths cli IN windows COMMAND test_windows_paths)
  endif()
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
scarp_add_test(cli.words cli IN windows NEEDS scarp COMMAND test_cli_words)

if("scarp" IN_LIST scarp_found)
  scarp_test_program(test_progress)
  target_include_directories(test_progress PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_progress PRIVATE _XOPEN_SOURCE=700)
  if(WIN32)
    target_sources(test_progress PRIVATE ${shared}/windows_files.c ${shared}/windows_system.c)
    target_link_libraries(test_progress PRIVATE shell32)
  endif()
endif()
scarp_add_test(cli.time_left cli IN windows NEEDS scarp COMMAND test_progress
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
scarp_add_test(cli.view_march cli NOT memory s390x NEEDS scarp COMMAND test_view_march)

if(UNIX)
  scarp_test_program(test_interrupt SOURCES ${PROJECT_SOURCE_DIR}/src/cli/shared/error.c
                     ${PROJECT_SOURCE_DIR}/src/cli/shared/interrupt.c)
  target_include_directories(test_interrupt PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_interrupt PRIVATE _XOPEN_SOURCE=700)
endif()
if(UNIX AND "pthreads" IN_LIST scarp_found)
  scarp_test_program(test_crew)
  target_include_directories(test_crew PRIVATE ${PROJECT_SOURCE_DIR}/src/cli)
  target_compile_definitions(test_crew PRIVATE SCARP_CLI_THREADS)
  target_link_libraries(test_crew PRIVATE Threads::Threads)
endif()
scarp_add_test(cli.crew threads IN threads NEEDS posix pthreads COMMAND test_crew)
scarp_add_test(cli.late_signal cli IN thorough NEEDS posix COMMAND test_interrupt)

# The essentials of the program without Python: one test per script of cli/*.sh
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
