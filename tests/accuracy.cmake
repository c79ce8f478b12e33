# SPDX-License-Identifier: MIT
# Compares the library with an independent oracle in double precision, and the oracle with published
# values and differences.

# Many points for the reference, fewer for each kernel that test_bits holds to it. Emulated
# processors are about 100 times slower.
set(accuracy_points_full 100000)
set(accuracy_points 20000)
if(NOT speed STREQUAL full)
  set(accuracy_points_full 5000)
  set(accuracy_points 1000)
endif()

scarp_test_program(oracle_check SOURCES ${oracle_sources} oracle_perlin.c)
scarp_add_test(accuracy.oracle accuracy oracle_check)

scarp_test_program(test_accuracy SOURCES ${oracle_sources})
scarp_add_test(accuracy.full accuracy test_accuracy ${accuracy_points_full} scalar)
scarp_add_isa_tests(accuracy accuracy test_accuracy ${accuracy_points})
