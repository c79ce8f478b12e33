# SPDX-License-Identifier: MIT
# Every kernel gives the bits of the scalar reference.

# Slow builds try some lengths of short calls, since full ones try all.
set(bits_step_emulated 11)
set(bits_step_slow 7)
set(bits_step_full 1)

scarp_test_program(test_bits)
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    scarp_add_sized_test(bits.${isa} bits IN core2duo:generic hostile i386:generic,sse4.1 windows wasm:wasm128,generic
                         NOT debug:sse4.1 hostile:sse4.1 s390x sanitized:generic,sse4.1,avx2
                         SIZES 6007 507 507 259 COMMAND test_bits ${isa} {} ${bits_step_${speed}})
  endif()
endforeach()
