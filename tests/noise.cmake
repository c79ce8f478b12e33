# SPDX-License-Identifier: MIT
# Tests kinds of noise by themselves: simplex noise, fractals, and what displaces positions by noise. Emulated
# processors are about 100 times slower.

# Simplex noise neither jumps nor prefers a direction; and what it shares with cellular noise.
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

# Compares fractals with the oracle, whose own derivatives oracle_check compares with differences, and with
# published values, and checks their ranges. test_bits holds every instruction set to the same bits, so one
# will do.

# 12 cases each in full: more than 10^5 points
scarp_test_program(test_fractal SOURCES ${oracle_sources})
scarp_add_sized_test(fractal.accuracy fractal NOT emulated s390x
                     SIZES 9000 2000 2000 1000 COMMAND test_fractal {})
scarp_test_program(test_fractal_published SOURCES ${oracle_sources})
scarp_add_sized_test(fractal.published fractal NOT emulated s390x
                     SIZES 10000 5000 2000 1000 COMMAND test_fractal_published {})

scarp_test_program(test_fractal_range)
scarp_add_sized_test(fractal.range fractal NOT emulated s390x
                     SIZES 100000 100000 100000 10000 COMMAND test_fractal_range {})

# Lines of each case
scarp_test_program(test_continuity)
scarp_add_sized_test(fractal.continuity fractal NOT emulated s390x
                     SIZES 1000 64 64 32 COMMAND test_continuity {})

# Noise with warps, and fractals whose octaves bend
scarp_test_program(test_warp)
scarp_add_isa_tests(warp warp IN wasm:wasm128,generic
                    NOT emulated:scalar s390x:generic sanitized:scalar,generic,sse4.1 COMMAND test_warp)
scarp_test_program(test_warp_api)
scarp_add_test(warp.api warp test_warp_api)

scarp_test_program(test_vector SOURCES ${oracle_sources})
scarp_add_isa_tests(vector warp IN wasm:wasm128,generic NOT emulated:scalar s390x sanitized:generic,sse4.1
                    COMMAND test_vector)

scarp_test_program(test_warp_exact SOURCES oracle_warp.c ${oracle_sources})
scarp_add_sized_test(warp.exact warp NOT emulated sanitized SIZES 4000 1000 1000 1000 COMMAND test_warp_exact {})

scarp_test_program(test_bend)
scarp_add_isa_tests(bend warp IN wasm:wasm128,generic
                    NOT aarch64:neon emulated:scalar s390x:generic sanitized:generic,sse4.1 COMMAND test_bend)
