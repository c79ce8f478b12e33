# SPDX-License-Identifier: MIT
# Noise with warps, and fractals whose octaves bend: both displace positions by noise. Emulated
# processors are about 100 times slower.

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
