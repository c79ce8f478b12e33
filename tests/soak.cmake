# SPDX-License-Identifier: MIT
# Random calls with everything that holds of them, and one hash of all results for every machine.

scarp_test_program(test_soak SOURCES fuzz/arguments.c fuzz/chain.c fuzz/compositions.c fuzz/gullies.c
                   fuzz/samples.c fuzz/shaders.c fuzz/vectors.c)
scarp_add_sized_test(soak soak IN armv7 hostile i386 mips64el musl vectors wasm windows
                     SIZES 50000 5000 2000 200
                     COMMAND test_soak {} ${CMAKE_CURRENT_LIST_DIR}/soak.txt)
