# SPDX-License-Identifier: MIT
# Every kernel gives the bits of the scalar reference.

set(bits_points_emulated 259)
set(bits_points_slow 1003)
set(bits_points_full 12007)
if(SCARP_TEST_THOROUGHLY)
  set(bits_points_full 40003)
endif()
set(bits_points ${bits_points_${speed}})
# Slow builds try some lengths of short calls, since full ones try all; NEON has no full one.
set(bits_step_emulated 5)
set(bits_step_slow 7)
set(bits_step_full 1)

scarp_test_program(test_bits)
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    set(step ${bits_step_${speed}})
    if(isa STREQUAL neon)
      set(step 1)
    endif()
    scarp_add_test(bits.${isa} bits test_bits ${isa} ${bits_points} ${step})
  endif()
endforeach()
