# SPDX-License-Identifier: MIT
# The committed hashes of outputs, on every instruction set and architecture.
scarp_test_program(test_golden)
scarp_add_isa_tests(golden golden test_golden ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
