# SPDX-License-Identifier: MIT
# Outputs have the committed hashes, with every instruction set and on every architecture. An emulator
# takes minutes for the reference and for the generic set, which are plain C: there they compute a part.
scarp_test_program(test_golden)
scarp_add_test(golden.frozen golden test_golden --frozen ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
foreach(isa IN LISTS isas)
  set(every)
  if(speed STREQUAL "emulated" AND isa MATCHES "scalar|generic")
    set(every 4)
  endif()
  scarp_add_test(golden.${isa} golden test_golden ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt ${isa} ${every})
endforeach()
