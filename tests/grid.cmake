# SPDX-License-Identifier: MIT
# Grids have the bits of the point calls.

scarp_test_program(test_grid)
foreach(isa IN LISTS isas)
  set(quick 4000)
  if(isa STREQUAL "scalar") # its grids are its points, one after the other
    set(quick 150)
  endif()
  scarp_add_sized_test(grid.${isa} grid IN core2duo:generic windows wasm:wasm128,generic
                       NOT emulated:scalar s390x:generic sanitized:scalar
                       SIZES 4000 ${quick} 800 150 COMMAND test_grid ${isa} {})
endforeach()

scarp_test_program(test_grid_safety)
scarp_add_isa_tests(grid_safety grid NOT emulated:scalar s390x COMMAND test_grid_safety)
