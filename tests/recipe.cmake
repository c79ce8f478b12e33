# SPDX-License-Identifier: MIT
# Recipes: the language and its calls, the same bits however they are computed, and an interpreter in
# double.

foreach(test recipe recipe_calls recipe_described recipe_summary)
  scarp_test_program(test_${test})
  string(REPLACE "_" "." name ${test})
  scarp_add_test(${name} recipe IN wasm COMMAND test_${test})
endforeach()

scarp_test_program(test_recipe_bits)
foreach(isa IN LISTS isas)
  scarp_add_sized_test(recipe.bits.${isa} recipe IN wasm
                       NOT debug:sse4.1 emulated:scalar sanitized:scalar,generic,sse4.1,avx2
                       SIZES 300 50 20 1
                       COMMAND test_recipe_bits ${isa} {} ${CMAKE_CURRENT_LIST_DIR}/recipes.txt)
endforeach()

scarp_test_program(test_recipe_skips)
foreach(isa IN LISTS isas)
  scarp_add_sized_test(recipe.skips.${isa} recipe IN wasm NOT emulated:scalar sanitized:scalar,generic,sse4.1,avx2
                       SIZES 2000 200 50 5
                       COMMAND test_recipe_skips ${isa} {})
endforeach()

scarp_test_program(test_recipe_plan)
scarp_add_isa_tests(recipe.plan recipe IN wasm:wasm128 NOT emulated:scalar sanitized:scalar,generic,sse4.1
                    COMMAND test_recipe_plan)

scarp_test_program(test_recipe_grids)
foreach(isa IN LISTS isas)
  scarp_add_sized_test(recipe.grids.${isa} recipe IN wasm
                       NOT debug:sse4.1 emulated:scalar sanitized:scalar,generic,sse4.1,avx2
                       SIZES 300 10 4 0
                       COMMAND test_recipe_grids ${isa} {})
endforeach()

scarp_test_program(test_recipe_oracle SOURCES oracle_recipe.c oracle_recipe_text.c oracle_gullies.c ${oracle_sources})
scarp_add_sized_test(recipe.oracle recipe IN wasm SIZES 10000 400 100 10 COMMAND test_recipe_oracle {})

# The functions of samples that recipes brought along
scarp_test_program(test_shapes)
scarp_add_test(shapes recipe COMMAND test_shapes)

# Values stay in the intervals of recipes: batches of 64 values for each function
scarp_test_program(test_recipe_interval INTERNAL)
scarp_add_sized_test(recipe.interval recipe IN wasm SIZES 200000 5000 1000 100
                     COMMAND test_recipe_interval {})

# No output is memory that nobody wrote, and calls inside of recipes that fail are noticed. The linker
# replaces these calls, those of statuses.h and of functions.def.
include(CheckLinkerFlag)
check_linker_flag(C -Wl,--wrap=scarp_add has_wrap)
if(has_wrap)
  scarp_test_program(test_recipe_status INTERNAL)
  file(STRINGS ${PROJECT_SOURCE_DIR}/src/recipe/statuses.h kept REGEX "^MUST_KEEP")
  list(TRANSFORM kept REPLACE "^MUST_KEEP[(](.*)[)];" "-Wl,--wrap=\\1")
  file(STRINGS ${PROJECT_SOURCE_DIR}/src/plan/functions.def functions REGEX "^(OPERATOR|FUNCTION)")
  list(TRANSFORM functions REPLACE "^[A-Z]+[(][A-Z_]+, ([a-z_]+),.*" "-Wl,--wrap=scarp_\\1")
  target_link_options(test_recipe_status PRIVATE ${kept} ${functions})
  scarp_add_test(recipe.status recipe IN wasm COMMAND test_recipe_status)
endif()

# The recipes of the program: water, directions, slopes, parameters
if(NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
  scarp_test_program(test_presets)
  target_link_libraries(test_presets PRIVATE scarp-presets)
  scarp_add_sized_test(presets presets NOT emulated sanitized SIZES 6 1 1 1 COMMAND test_presets {})

  # Recipes at the origin: nothing is special there
  scarp_test_program(test_recipe_origin)
  target_link_libraries(test_recipe_origin PRIVATE scarp-presets)
  scarp_add_sized_test(recipe.origin recipe SIZES 2000 500 200 50 COMMAND test_recipe_origin {})

  # What calls change in recipes, and what these say of themselves
  scarp_test_program(test_recipe_change)
  target_link_libraries(test_recipe_change PRIVATE scarp-presets)
  scarp_add_test(recipe.change recipe COMMAND test_recipe_change)
endif()
