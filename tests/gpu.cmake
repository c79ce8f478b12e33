# SPDX-License-Identifier: MIT
# Tests the noise of shaders: what the library gives to them.

scarp_test_program(test_gpu_plan INTERNAL)
scarp_add_test(gpu.plan gpu test_gpu_plan)
scarp_test_program(test_gpu_answers)
scarp_add_isa_tests(gpu.answers gpu test_gpu_answers)
