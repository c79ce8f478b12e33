# SPDX-License-Identifier: MIT
# The recipes of the program: water, directions, slopes, parameters

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
