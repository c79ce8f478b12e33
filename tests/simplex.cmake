# SPDX-License-Identifier: MIT
# Tests that simplex noise neither jumps nor prefers a direction, and what it shares with cellular
# noise. Emulated processors are about 100 times slower.

set(simplex_points_full 1000000)
set(simplex_points_slow 20000)
set(simplex_points_emulated 2000)
scarp_test_program(test_simplex)
foreach(isa IN LISTS isas)
  set(points ${simplex_points_${speed}})
  if(isa STREQUAL scalar AND speed STREQUAL full)
    set(points 50000)
  endif()
  scarp_add_test(simplex.${isa} simplex NOT s390x sanitized:generic,sse4.1 COMMAND test_simplex ${isa} ${points})
endforeach()
