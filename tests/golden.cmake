# SPDX-License-Identifier: MIT
# Outputs have the committed hashes, with every instruction set and on every architecture.
scarp_test_program(test_golden)
scarp_add_isa_tests(golden golden test_golden ${CMAKE_CURRENT_SOURCE_DIR}/golden.txt)
