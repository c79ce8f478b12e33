# SPDX-License-Identifier: MIT
# Do the tests notice mistakes? The library is compiled once more, with all mistakes of
# mutants/list.cmake in it, each of which can be switched on; test programs that are linked to it
# must then see a difference, on every kernel set, and none while no mistake is switched on.

set(mutants_from ${PROJECT_SOURCE_DIR}/src)
set(mutants_to ${CMAKE_CURRENT_BINARY_DIR}/mutants)
file(GLOB_RECURSE mutants_files CONFIGURE_DEPENDS RELATIVE ${mutants_from}
     ${mutants_from}/*.c ${mutants_from}/*.h)
list(FILTER mutants_files EXCLUDE REGEX "^cli/")
list(TRANSFORM mutants_files PREPEND ${mutants_from}/ OUTPUT_VARIABLE mutants_originals)
set(mutants_sources ${scarp_sources})
list(TRANSFORM mutants_sources REPLACE "^src" ${mutants_to})

add_custom_command(
  OUTPUT ${mutants_sources} ${mutants_to}/mutants.c
  COMMAND ${CMAKE_COMMAND} -D FROM=${mutants_from} -D TO=${mutants_to} -D "FILES=${mutants_files}"
          -P ${CMAKE_CURRENT_SOURCE_DIR}/mutants/mutate.cmake
  DEPENDS mutants/list.cmake mutants/mutate.cmake ${mutants_originals}
  COMMENT "Writing the sources with mistakes" VERBATIM)
add_library(scarp_mutants STATIC ${mutants_sources} ${mutants_to}/mutants.c)
scarp_compile_rules(scarp_mutants)
scarp_library_rules(scarp_mutants)
# Whatever a set leaves out because it is small (vec.h) is to have its mistakes, too.
target_compile_definitions(scarp_mutants PRIVATE VEC_SMALL=0)
if(SCARP_OPTIMIZE AND NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  target_compile_options(scarp_mutants PRIVATE -O1) # compiles faster than at any other level
endif()

if(CMAKE_C_FLAGS MATCHES "-fsanitize")
  target_compile_options(scarp_mutants PRIVATE -fno-sanitize=all) # it is meant to do what is wrong
endif()

foreach(test bits chain curl golden grid plan)
  add_executable(mutant_${test} test_${test}.c)
  scarp_compile_rules(mutant_${test})
  target_link_libraries(mutant_${test} PRIVATE scarp_mutants ${SCARP_LIBM})
endforeach()

# The command for each SEEN_BY: run_* comes before the kernel set, then_* behind it.
set(golden_file ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
set(run_bits mutant_bits --must-differ)
set(run_chain mutant_chain --must-differ)
set(run_grid mutant_grid --must-differ)
set(run_large mutant_grid --must-differ)
set(run_golden mutant_golden --must-differ ${golden_file})
set(run_crash mutant_grid --must-crash)
set(run_plan mutant_plan --must-differ)
set(run_curl mutant_curl --must-differ)
set(then_bits 131 13)
set(then_grid 2000) # at most: it ends at the first difference
set(then_large 0)
set(then_crash 0)

function(mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TEXT;BECOMES;SEEN_BY" "IN;SETS")
  set(sets ${arg_SETS})
  if(NOT sets)
    set(sets ${isas})
    list(REMOVE_ITEM sets scalar)
  endif()
  foreach(isa IN LISTS sets)
    scarp_add_test(mutant.${name}.${isa} mutants ${run_${arg_SEEN_BY}} ${isa} ${then_${arg_SEEN_BY}})
    set_tests_properties(mutant.${name}.${isa} PROPERTIES ENVIRONMENT SCARP_MUTANT=${name})
  endforeach()
endfunction()
include(mutants/list.cmake)

foreach(isa IN LISTS isas)
  scarp_add_test(mutant.none.bits.${isa} mutants mutant_bits ${isa} ${then_bits})
  scarp_add_test(mutant.none.chain.${isa} mutants mutant_chain ${isa})
  scarp_add_test(mutant.none.plan.${isa} mutants mutant_plan ${isa})
  scarp_add_test(mutant.none.curl.${isa} mutants mutant_curl ${isa})
  scarp_add_test(mutant.none.grid.${isa} mutants mutant_grid ${isa} 250)
  scarp_add_test(mutant.none.golden.${isa} mutants mutant_golden ${golden_file} ${isa})
endforeach()
