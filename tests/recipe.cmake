# SPDX-License-Identifier: MIT
# Recipes: the language and its calls, the same bits however they are computed, and an interpreter in
# double.

scarp_test_program(test_recipe)
scarp_add_test(recipe recipe COMMAND test_recipe)

scarp_test_program(test_recipe_bits)
foreach(isa IN LISTS isas)
  scarp_add_sized_test(recipe.bits.${isa} recipe SIZES 300 50 20 1
                       COMMAND test_recipe_bits ${isa} {} ${CMAKE_CURRENT_LIST_DIR}/recipes.txt)
endforeach()

scarp_test_program(test_recipe_oracle SOURCES oracle_recipe.c oracle_gullies.c ${oracle_sources})
scarp_add_sized_test(recipe.oracle recipe SIZES 10000 400 100 10 COMMAND test_recipe_oracle {})

# The functions of samples that recipes brought along
scarp_test_program(test_shapes)
scarp_add_test(shapes recipe COMMAND test_shapes)
