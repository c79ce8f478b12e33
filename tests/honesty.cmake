# SPDX-License-Identifier: MIT
# How exact gradients are, and how much of the promised ranges is met: the tables of
# bench/results.md, with fewer points

scarp_test_program(honesty SOURCES honesty_subjects.c oracle_gullies.c oracle_recipe.c oracle_recipe_text.c oracle_warp.c
                   ${oracle_sources})
target_link_libraries(honesty PRIVATE scarp-presets)
scarp_add_sized_test(honesty accuracy NOT emulated sanitized SIZES 512 12 4 2 COMMAND honesty {})
