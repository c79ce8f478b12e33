# SPDX-License-Identifier: MIT
# Grids have the bits of the point calls.

set(grid_cases 4000)
if(speed STREQUAL "slow")
  set(grid_cases 800)
elseif(speed STREQUAL "emulated")
  set(grid_cases 150)
endif()
scarp_test_program(test_grid)
foreach(isa IN LISTS isas)
  scarp_add_test(grid.${isa} grid test_grid ${isa} ${grid_cases})
endforeach()

scarp_test_program(test_grid_safety)
scarp_add_isa_tests(grid_safety grid test_grid_safety)
