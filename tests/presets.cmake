# SPDX-License-Identifier: MIT
# The recipes of the program: water, directions, slopes, parameters

scarp_test_program(test_presets)
target_link_libraries(test_presets PRIVATE scarp-presets)
scarp_add_sized_test(presets presets SIZES 6 1 1 1 COMMAND test_presets {})
