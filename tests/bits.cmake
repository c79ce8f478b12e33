# SPDX-License-Identifier: MIT
# The same bits, however and wherever they are computed

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

# Every kernel gives the bits of the scalar reference. Slow builds try some lengths of short calls, since
# full ones try all.
set(bits_step_emulated 11)
set(bits_step_slow 7)
set(bits_step_full 1)

scarp_test_program(test_bits)
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    scarp_add_sized_test(bits.${isa} bits IN core2duo:generic hostile i386:generic,sse4.1 windows wasm:wasm128,generic
                         NOT debug:sse4.1 hostile:sse4.1 s390x sanitized:generic,sse4.1,avx2
                         SIZES 6007 507 507 259 COMMAND test_bits ${isa} {} ${bits_step_${speed}})
  endif()
endforeach()

# Grids have the bits of the point calls.
scarp_test_program(test_grid)
foreach(isa IN LISTS isas)
  set(quick 4000)
  if(isa STREQUAL "scalar") # its grids are its points, one after the other
    set(quick 150)
  endif()
  scarp_add_sized_test(grid.${isa} grid IN core2duo:generic windows wasm:wasm128,generic
                       NOT emulated:scalar s390x:generic sanitized:scalar
                       SIZES 4000 ${quick} 800 150 COMMAND test_grid ${isa} {})
endforeach()

scarp_test_program(test_grid_safety)
scarp_add_isa_tests(grid_safety grid NOT emulated:scalar s390x COMMAND test_grid_safety)

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

# Random calls with everything that holds of them, and one hash of all results for every machine
scarp_test_program(test_soak SOURCES fuzz/arguments.c fuzz/chain.c fuzz/compositions.c fuzz/gullies.c
                   fuzz/samples.c fuzz/shaders.c fuzz/vectors.c)
scarp_add_sized_test(soak soak IN armv7 hostile i386 mips64el musl vectors wasm windows
                     SIZES 50000 5000 2000 200
                     COMMAND test_soak {} ${CMAKE_CURRENT_LIST_DIR}/soak.txt)
