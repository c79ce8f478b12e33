# SPDX-License-Identifier: MIT
# Tests the mathematics of flow noise: proves its suprema, compares how its gradients turn with libm
# and the header, and searches for values outside the ranges. Emulated processors are about 100 times
# slower.

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
