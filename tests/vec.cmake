# SPDX-License-Identifier: MIT
# Compares each vector operation of each instruction set with plain C. The files of src/simd are
# compiled once more, with the operations in place of the kernels.

set(vec_sources ${scarp_sources})
list(FILTER vec_sources INCLUDE REGEX src/simd/)
list(TRANSFORM vec_sources PREPEND ${PROJECT_SOURCE_DIR}/)
scarp_test_program(test_vec SOURCES ${vec_sources})
target_include_directories(test_vec PRIVATE ${CMAKE_CURRENT_LIST_DIR})
if(SCARP_OPTIMIZE) # as the kernels are
  target_compile_options(test_vec PRIVATE $<$<CONFIG:Release>:${optimize}>)
endif()
target_compile_definitions(test_vec PRIVATE ${SCARP_SET_DEFINITIONS} "KERNELS_BODY=\"vec/operations.h\"")
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    scarp_add_test(vec.${isa} vec IN clang14 core2duo:generic hostile i386:generic,sse4.1 mips64el:generic vectors
                      wasm:wasm128,generic
                   COMMAND test_vec ${isa})
  endif()
endforeach()
