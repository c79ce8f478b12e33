# SPDX-License-Identifier: MIT
# Every kernel gives the bits of the scalar reference.

set(bits_points_emulated 259)
set(bits_points_slow 2003)
set(bits_points_full 12007)
if(SCARP_TEST_THOROUGHLY)
  set(bits_points_full 40003)
endif()
set(bits_points ${bits_points_${speed}})

scarp_test_program(test_bits)
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    scarp_add_test(bits.${isa} bits test_bits ${isa} ${bits_points})
  endif()
endforeach()
