# SPDX-License-Identifier: MIT
# Tests the lattice hash and the keys. Emulated processors are about 100 times slower.

set(hash_bits 20)
if(NOT speed STREQUAL full)
  set(hash_bits 14)
endif()

scarp_test_program(test_hash INTERNAL)
scarp_add_test(hash hash test_hash ${hash_bits})
