# SPDX-License-Identifier: MIT
# Outputs have the committed hashes, with every instruction set and on every architecture. An emulator
# takes minutes for them: there they compute a part, which is smaller for the reference and for the generic
# set, since these are plain C.
scarp_test_program(test_golden)
scarp_add_test(golden.frozen golden IN clang14 hostile musl wasm windows windows-clang
               COMMAND test_golden --frozen ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
foreach(isa IN LISTS isas)
  set(every)
  if(speed STREQUAL "emulated" AND isa MATCHES "scalar|generic")
    set(every 4)
  elseif(speed STREQUAL "emulated")
    set(every 2)
  endif()
  scarp_add_test(golden.${isa} golden
                 IN armv7:scalar clang14 core2duo:generic hostile i386:scalar,generic,sse4.1 mips64el:generic musl
                    vectors:generic wasm windows windows-clang
                 NOT aarch64:scalar debug:scalar sanitized:scalar
                 COMMAND test_golden ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt ${isa} ${every})
endforeach()
