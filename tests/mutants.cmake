# SPDX-License-Identifier: MIT
# Do the tests notice mistakes? The library is compiled once more, with all mistakes of
# mutants/list.cmake in it, each of which can be switched on; test programs that are linked to it
# must then see a difference, on every kernel set, and none while no mistake is switched on
# (mutants/run.c). What they see with few points, the default tests see with more. mutants/rules/ makes
# mistakes by rule besides, thousands of them, of which a sample can be tried.

# Both lists name texts of the sources. These are as they say, which default tests check.
scarp_add_test(mutants.texts mutants COMMAND ${CMAKE_COMMAND} -D FROM=${PROJECT_SOURCE_DIR}/src
               -P ${CMAKE_CURRENT_SOURCE_DIR}/mutants/mutate.cmake)
scarp_add_test(mutants.explained mutants NEEDS python3 COMMAND ${Python3_EXECUTABLE} -B
               ${CMAKE_CURRENT_SOURCE_DIR}/mutants/rules/rules.py --stale)
if(NOT SCARP_TEST_THOROUGH OR NOT UNIX) # what follows forks
  return()
endif()

set(mutants_from ${PROJECT_SOURCE_DIR}/src)
set(mutants_to ${CMAKE_CURRENT_BINARY_DIR}/mutants)
file(GLOB_RECURSE mutants_files CONFIGURE_DEPENDS RELATIVE ${mutants_from}
     ${mutants_from}/*.c ${mutants_from}/*.h ${mutants_from}/*.def)
list(FILTER mutants_files EXCLUDE REGEX "^cli/")
list(TRANSFORM mutants_files PREPEND ${mutants_from}/ OUTPUT_VARIABLE mutants_originals)
set(mutants_sources ${scarp_sources})
list(TRANSFORM mutants_sources REPLACE "^src" ${mutants_to})

add_custom_command(
  OUTPUT ${mutants_sources} ${mutants_to}/mutants.c
  COMMAND ${CMAKE_COMMAND} -D FROM=${mutants_from} -D TO=${mutants_to}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/mutants/mutate.cmake
  DEPENDS mutants/list.cmake mutants/mutate.cmake ${mutants_originals}
  COMMENT "Writing the sources with mistakes" VERBATIM)
add_library(scarp_mutants STATIC ${mutants_sources} ${mutants_to}/mutants.c)
scarp_compile_rules(scarp_mutants)
scarp_library_rules(scarp_mutants)
target_include_directories(scarp_mutants PRIVATE mutants)
# Whatever a set leaves out because it is small (vec.h) is to have its mistakes, too.
target_compile_definitions(scarp_mutants PRIVATE VEC_SMALL=0)
if(SCARP_OPTIMIZE AND NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  # compiles faster than at any other level
  set_property(SOURCE ${mutants_sources} APPEND PROPERTY COMPILE_OPTIONS -O1)
endif()

if(CMAKE_C_FLAGS MATCHES "-fsanitize")
  target_compile_options(scarp_mutants PRIVATE -fno-sanitize=all) # it is meant to do what is wrong
endif()

set(mutants_beside_vector ${oracle_sources})
foreach(test bits chain curl golden grid gullies plan recipe_bits recipe_grids recipe_skips vector)
  add_library(mutant_${test}_test OBJECT test_${test}.c ${mutants_beside_${test}})
  scarp_compile_rules(mutant_${test}_test)
  target_include_directories(mutant_${test}_test PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(mutant_${test}_test PRIVATE main=test_main)
  target_compile_options(mutant_${test}_test PRIVATE -Wno-missing-prototypes)
  add_executable(mutant_${test} mutants/run.c $<TARGET_OBJECTS:mutant_${test}_test>)
  scarp_compile_rules(mutant_${test})
  target_include_directories(mutant_${test} PRIVATE mutants)
  target_compile_definitions(mutant_${test} PRIVATE _POSIX_C_SOURCE=200809L TEST="${test}"
                             RECIPES_FILE="${CMAKE_CURRENT_SOURCE_DIR}/recipes.txt")
  target_link_libraries(mutant_${test} PRIVATE scarp_mutants ${SCARP_LIBM})
  set(program_of_${test} ${test}) # of a word after SEEN_BY
endforeach()
set(program_of_large grid)
set(program_of_crash grid)

# A test per program and kernel set for which the list has a mistake
function(mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TEXT;BECOMES;SEEN_BY" "IN;SETS")
  if(NOT arg_SETS)
    set(arg_SETS ${isas})
    list(REMOVE_ITEM arg_SETS scalar)
  endif()
  foreach(isa IN LISTS arg_SETS)
    set(test mutants.${program_of_${arg_SEEN_BY}}.${isa})
    if(isa IN_LIST isas AND NOT TEST ${test})
      scarp_add_test(${test} mutants IN thorough COMMAND mutant_${program_of_${arg_SEEN_BY}} ${isa}
                     ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
    endif()
  endforeach()
endfunction()
include(mutants/list.cmake)

# Mutations by rule: the script itself, and all of one small file, which must be noticed.
scarp_add_test(mutants.rules mutants IN thorough NEEDS python3 COMMAND ${Python3_EXECUTABLE} -B
               ${CMAKE_CURRENT_SOURCE_DIR}/mutants/rules/test_rules.py ${CMAKE_CURRENT_BINARY_DIR}/mutants/rules)
if("avx2" IN_LIST isas AND speed STREQUAL "full")
  scarp_add_test(mutants.rules.fades mutants IN thorough NEEDS python3 COMMAND ${Python3_EXECUTABLE} -B
                 ${CMAKE_CURRENT_SOURCE_DIR}/mutants/rules/rules.py
                 --work ${CMAKE_CURRENT_BINARY_DIR}/mutants/fades --files kernel/basis/fade.h --sample 0
                 --no-default --quick "test_bits ISA 131 13")
endif()
foreach(test mutants.rules mutants.rules.fades)
  if(TEST ${test})
    set_tests_properties(${test} PROPERTIES ENVIRONMENT "CC=${CMAKE_C_COMPILER}")
  endif()
endforeach()
