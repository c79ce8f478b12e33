# SPDX-License-Identifier: MIT
# Tests from outside that scarp-bench measures and reports, not how fast anything is.

set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-bench>)
set(script ${CMAKE_CURRENT_LIST_DIR}/test_bench.py)
function(scarp_add_bench_test group) # of test_bench.py
  string(TOLOWER ${group} name)
  scarp_add_test(bench.${name} bench ${ARGN} NEEDS scarp-bench python3
                 COMMAND ${Python3_EXECUTABLE} -B ${script} ${group} ${program})
endfunction()
scarp_add_bench_test(Selection NOT sanitized)
scarp_add_bench_test(Results IN thorough NOT sanitized)
scarp_add_bench_test(Every IN thorough)
scarp_add_bench_test(Errors)

if("scarp-bench" IN_LIST scarp_found)
  scarp_test_program(test_bench_presets SOURCES ${PROJECT_SOURCE_DIR}/bench/names.c
                     ${PROJECT_SOURCE_DIR}/bench/work.c)
  target_link_libraries(test_bench_presets PRIVATE scarp-presets)
  set(bench ${PROJECT_SOURCE_DIR}/bench)
  scarp_test_program(test_bench_hand SOURCES ${bench}/arrays.c ${bench}/hand_recipes.c ${bench}/names.c
                     ${bench}/peer_hand.c ${bench}/platform.c ${bench}/recipes.c ${bench}/work.c
                     ${PROJECT_BINARY_DIR}/bench/recipes_texts.c)
  target_include_directories(test_bench_hand PRIVATE ${bench})
  target_link_libraries(test_bench_hand PRIVATE scarp-presets)
endif()
scarp_add_test(bench.presets bench NEEDS scarp-bench COMMAND test_bench_presets)
scarp_add_test(bench.hand bench NEEDS scarp-bench COMMAND test_bench_hand)

# Compares instructions per point with the committed figures. A busy machine does not change them.
set(cost_processor ${CMAKE_SYSTEM_PROCESSOR})
if(CMAKE_CROSSCOMPILING_EMULATOR)
  set(cost_processor emulated)
endif()
scarp_test_program(test_cost)
scarp_add_test(cost cost IN thorough NEEDS python3 valgrind
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_cost.py
               $<TARGET_FILE:test_cost> ${CMAKE_CURRENT_SOURCE_DIR}/cost.txt
               ${CMAKE_CURRENT_BINARY_DIR} "processor: ${cost_processor}"
               "${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}"
               "build type: $<CONFIG>" "flags: ${CMAKE_C_FLAGS}")
