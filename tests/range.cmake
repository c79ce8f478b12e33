# SPDX-License-Identifier: MIT
# Tests the guaranteed ranges: proves the suprema, and searches for values outside the ranges.
# Emulated processors are about 100 times slower.

scarp_test_program(test_range SOURCES ${oracle_sources})
scarp_add_sized_test(range range NOT emulated sanitized SIZES 10000000 1000000 50000 50000 COMMAND test_range {})

set(suprema_slack 1e-12 1e-9) # of simplex and cellular noise, relatively
if(speed STREQUAL emulated)
  set(suprema_slack 1e-6 1e-6)
endif()
list(GET suprema_slack 0 simplex_slack)
list(GET suprema_slack 1 cells_slack)

scarp_test_program(test_suprema_simplex)
scarp_add_test(range.simplex range NOT emulated sanitized COMMAND test_suprema_simplex ${simplex_slack})
scarp_test_program(test_suprema_cells)
scarp_add_test(range.cells range NOT emulated sanitized COMMAND test_suprema_cells ${cells_slack})
