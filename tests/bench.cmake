# SPDX-License-Identifier: MIT
# Tests from outside that scarp-bench measures and reports, not how fast anything is.

set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-bench>)
set(script ${CMAKE_CURRENT_LIST_DIR}/test_bench.py)
foreach(group Selection Results Every Errors)
  string(TOLOWER ${group} name)
  scarp_add_test(bench.${name} bench NEEDS scarp-bench python3
                 COMMAND ${Python3_EXECUTABLE} ${script} ${group} ${program})
endforeach()

if("scarp" IN_LIST scarp_found AND "scarp-bench" IN_LIST scarp_found)
  set(cli ${PROJECT_SOURCE_DIR}/src/cli)
  scarp_test_program(test_bench_presets SOURCES
    ${PROJECT_SOURCE_DIR}/bench/names.c ${PROJECT_SOURCE_DIR}/bench/work.c ${cli}/shared/json.c ${cli}/shared/noise.c
    ${cli}/shared/number.c ${cli}/shared/options.c ${cli}/shared/options_describe.c
    ${cli}/shared/running_options.c ${cli}/shared/text.c ${cli}/shared/values.c ${cli}/ground/ground_options.c
    ${cli}/ground/presets.c ${cli}/look/look_options.c ${cli}/terrain/terrain_options.c)
  target_include_directories(test_bench_presets PRIVATE ${cli})
endif()
scarp_add_test(bench.presets bench NEEDS scarp scarp-bench COMMAND test_bench_presets)
