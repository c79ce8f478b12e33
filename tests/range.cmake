# SPDX-License-Identifier: MIT
# Tests the guaranteed ranges: proves the suprema, and searches for values outside the ranges.
# Emulated processors are about 100 times slower.

set(range_points 10000000)
if(NOT speed STREQUAL full)
  set(range_points 50000)
endif()

scarp_test_program(test_range SOURCES oracle.c oracle_basis.c oracle_fractal.c oracle_phase.c)
scarp_add_test(range range test_range ${range_points})
