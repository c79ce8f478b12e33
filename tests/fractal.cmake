# SPDX-License-Identifier: MIT
# Compares turbulence, ridged and erosion with the oracle, with differences, and with sums of single
# octaves, and checks their ranges. test_bits holds every instruction set to the same bits, so one
# will do. Emulated processors are about 100 times slower.

set(fractal_points_full 9000) # 12 cases each: more than 10^5 points
set(fractal_points_slow 2000)
set(fractal_points_emulated 1000)
set(fractal_points ${fractal_points_${speed}})

scarp_test_program(test_fractal SOURCES ${oracle_sources})
scarp_add_test(fractal.accuracy fractal test_fractal ${fractal_points})

set(fractal_exact_full 26000) # 4 cases each: more than 10^5 points
set(fractal_exact_slow 4000)
set(fractal_exact_emulated 1000)
scarp_test_program(test_fractal_exact SOURCES ${oracle_sources})
scarp_add_test(fractal.exact fractal test_fractal_exact ${fractal_exact_${speed}})

set(fractal_blocks_full 10000)
set(fractal_blocks_slow 2000)
set(fractal_blocks_emulated 1000)
scarp_test_program(test_fractal_rebuild)
scarp_add_test(fractal.rebuild fractal test_fractal_rebuild ${fractal_blocks_${speed}})
scarp_test_program(test_fractal_published SOURCES ${oracle_sources})
scarp_add_test(fractal.published fractal test_fractal_published ${fractal_blocks_${speed}})

set(fractal_range_full 100000)
set(fractal_range_slow 100000)
set(fractal_range_emulated 10000)
scarp_test_program(test_fractal_range)
scarp_add_test(fractal.range fractal test_fractal_range ${fractal_range_${speed}})
