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

# The mathematics of flow noise: proves its suprema, compares how its gradients turn with libm and the
# header, and searches for values outside the ranges.
set(phase_slack 1e-11 0) # in 2D and 3D
if(speed STREQUAL emulated)
  set(phase_slack 1e-6 5e-2)
endif()

scarp_test_program(test_phase_range INTERNAL SOURCES ${oracle_sources})
scarp_add_test(phase.range phase NOT emulated s390x sanitized COMMAND test_phase_range ${phase_slack})

set(phase_turns_full 10000)
set(phase_turns_slow 2000)
set(phase_turns_emulated 300)
scarp_test_program(test_phase_turn INTERNAL)
scarp_add_test(phase.turn phase NOT emulated s390x sanitized COMMAND test_phase_turn ${phase_turns_${speed}})

set(phase_points_full 5000000)
set(phase_points_slow 1000000)
set(phase_points_emulated 100000)
scarp_test_program(test_phase_reach)
scarp_add_test(phase.reach phase NOT emulated s390x sanitized COMMAND test_phase_reach ${phase_points_${speed}})
