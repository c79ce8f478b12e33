# SPDX-License-Identifier: MIT
# Compares the library with an independent oracle in double precision, and the oracle with published
# values and differences.

scarp_test_program(oracle_check SOURCES ${oracle_sources} oracle_perlin.c)
scarp_add_test(accuracy.oracle accuracy NOT aarch64 s390x COMMAND oracle_check)
scarp_test_program(oracle_published SOURCES ${oracle_sources})
scarp_add_test(accuracy.published accuracy NOT aarch64 s390x COMMAND oracle_published)
scarp_test_program(test_cells_published SOURCES ${oracle_sources})
scarp_add_sized_test(accuracy.cells_published accuracy NOT aarch64 s390x
                     SIZES 1000000 40000 10000 2000 COMMAND test_cells_published {})

scarp_test_program(test_gullies_exact SOURCES ${oracle_sources} oracle_gullies.c)
scarp_add_sized_test(accuracy.gullies accuracy NOT aarch64 s390x
                     SIZES 20000 1000 1000 200 COMMAND test_gullies_exact {})

scarp_test_program(test_accuracy SOURCES ${oracle_sources})
foreach(isa IN LISTS isas)
  set(sizes 20000 2000 1000 1000)
  if(isa STREQUAL "scalar") # test_bits holds the others to it
    set(sizes 50000 2500 2500 1000)
  endif()
  scarp_add_sized_test(accuracy.${isa} accuracy IN hostile NOT aarch64 s390x
                       SIZES ${sizes} COMMAND test_accuracy {} ${isa})
endforeach()

# How exact gradients are, and how much of the promised ranges is met: the tables of
# bench/results.md, with fewer points
scarp_test_program(honesty SOURCES honesty_subjects.c oracle_gullies.c oracle_recipe.c oracle_recipe_text.c oracle_warp.c
                   ${oracle_sources})
target_link_libraries(honesty PRIVATE scarp-presets)
scarp_add_sized_test(honesty accuracy NOT emulated sanitized SIZES 512 12 4 2 COMMAND honesty {})

# The lattice hash and the keys
scarp_test_program(test_hash INTERNAL)
scarp_add_sized_test(hash hash NOT emulated sanitized SIZES 19 16 14 14 COMMAND test_hash {})
