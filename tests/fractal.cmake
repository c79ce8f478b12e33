# SPDX-License-Identifier: MIT
# Compares fractals with the oracle, whose own derivatives oracle_check compares with differences, and with
# published values, and checks their ranges. test_bits holds every instruction set to the same bits, so one
# will do. Emulated processors are about 100 times slower.

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
