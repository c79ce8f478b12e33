# SPDX-License-Identifier: MIT
# Tests the promises of scarp.h that are not about the noise itself.

scarp_test_program(test_api)
scarp_add_isa_tests(api api IN wasm:wasm128,generic NOT emulated sanitized:scalar COMMAND test_api)

scarp_test_program(test_special SOURCES ${oracle_sources})
foreach(isa IN LISTS isas) # sizes are strides here
  scarp_add_sized_test(special.${isa} api
                       IN armv7:scalar core2duo:generic hostile i386:scalar,generic,sse4.1 mips64el:generic musl windows
                          wasm:wasm128,generic
                       NOT emulated:scalar s390x sanitized:scalar,generic,sse4.1
                       SIZES 1 3 3 11 COMMAND test_special ${isa} {})
endforeach()

scarp_test_program(test_fpmode)
scarp_add_isa_tests(fpmode api IN hostile NOT aarch64:scalar s390x sanitized:scalar COMMAND test_fpmode)

# The same program as a user may build it: -ffast-math flushes denormals from the start on.
if(NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  add_executable(test_fpmode_fastmath test_fpmode.c)
  scarp_compile_rules(test_fpmode_fastmath)
  target_compile_options(test_fpmode_fastmath PRIVATE -ffast-math)
  target_link_options(test_fpmode_fastmath PRIVATE -ffast-math)
  target_link_libraries(test_fpmode_fastmath PRIVATE scarp ${SCARP_LIBM})
  scarp_add_isa_tests(fpmode_fastmath api IN hostile COMMAND test_fpmode_fastmath --started)
endif()

scarp_test_program(test_faults)
scarp_add_test(faults api COMMAND test_faults)

scarp_test_program(test_plan)
scarp_add_isa_tests(plan api IN clang14 core2duo:generic vectors COMMAND test_plan)

scarp_test_program(test_period)
scarp_add_isa_tests(period api NOT aarch64:neon emulated:scalar s390x sanitized:scalar,generic,sse4.1
                    COMMAND test_period)

scarp_test_program(test_origin)
scarp_add_isa_tests(origin api test_origin)
scarp_add_test(origin.seeds api test_origin seeds)

scarp_test_program(test_phase SOURCES ${oracle_sources})
scarp_add_isa_tests(phase api NOT emulated:scalar s390x sanitized:scalar,generic,sse4.1 COMMAND test_phase)

scarp_test_program(test_cells)
scarp_add_isa_tests(cells api IN clang14 core2duo:generic vectors wasm:wasm128,generic COMMAND test_cells)

scarp_test_program(test_chain)
scarp_add_isa_tests(chain api IN wasm:wasm128,generic NOT emulated:scalar sanitized:scalar,generic,sse4.1
                    COMMAND test_chain)
scarp_test_program(test_chain_rule)
scarp_add_isa_tests(chain_rule api NOT emulated:scalar COMMAND test_chain_rule)
scarp_test_program(test_chain_zero)
scarp_add_isa_tests(chain_zero api NOT s390x:scalar COMMAND test_chain_zero)
scarp_test_program(test_curl)
scarp_add_isa_tests(curl api IN wasm:wasm128,generic
                    NOT emulated:scalar s390x:generic sanitized:scalar,generic,sse4.1 COMMAND test_curl)
scarp_test_program(test_gullies)
scarp_add_isa_tests(gullies api IN wasm:wasm128,generic NOT sanitized:generic,sse4.1 COMMAND test_gullies)

scarp_test_program(test_memory)
scarp_add_isa_tests(memory api IN hostile NOT emulated:scalar s390x COMMAND test_memory)

if("pthreads" IN_LIST scarp_found)
  scarp_test_program(test_threads)
  target_link_libraries(test_threads PRIVATE Threads::Threads)
endif()
scarp_add_test(threads threads IN musl threads NEEDS pthreads COMMAND test_threads)

# The header's promise about the stack, 48 KiB, holds for optimised builds without instruments, whatever
# their flags. In builds with only the flags of the project, calls take at most 45: other flags get the rest.
set(stack_kib 48)
if(SCARP_OPTIMIZE AND NOT CMAKE_C_FLAGS AND NOT CMAKE_BUILD_TYPE STREQUAL "MinSizeRel")
  set(stack_kib 45)
endif()
if(UNIX AND "pthreads" IN_LIST scarp_found AND "optimised" IN_LIST scarp_found)
  scarp_test_program(test_stack)
  target_link_libraries(test_stack PRIVATE Threads::Threads)
  target_compile_definitions(test_stack PRIVATE STACK_KIB=${stack_kib})
endif()
set(every)
if(speed STREQUAL "emulated")
  set(every 5)
endif()
foreach(isa IN LISTS isas)
  scarp_add_test(stack.${isa} api IN clang14 hostile musl NOT emulated:scalar s390x
                 NEEDS pthreads posix optimised COMMAND test_stack ${isa} ${every})
endforeach()
