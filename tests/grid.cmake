# SPDX-License-Identifier: MIT
# Grids have the bits of points.

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

# Large grids alone: the mistake shows that they are streamed at all.
if("${mutant_isa}" STREQUAL "avx2")
  scarp_mutant_program(test_grid avx2 stream)
  scarp_add_test(grid.mutant.avx2.stream grid test_grid_avx2_stream avx2 0)
  set_tests_properties(grid.mutant.avx2.stream PROPERTIES WILL_FAIL TRUE)
endif()

scarp_test_program(test_grid_safety)
scarp_add_isa_tests(grid_safety grid test_grid_safety)
