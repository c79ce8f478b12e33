# SPDX-License-Identifier: MIT
# Tests the lattice hash and the keys.

scarp_test_program(test_hash INTERNAL)
scarp_add_sized_test(hash hash NOT emulated sanitized SIZES 19 16 14 14 COMMAND test_hash {})
