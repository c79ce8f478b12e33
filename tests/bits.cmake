# SPDX-License-Identifier: MIT
# Every kernel equals the scalar reference; and a kernel with a deliberate mistake does not.

set(bits_points_emulated 259)
set(bits_points_slow 2003)
set(bits_points_full 12007)
if(SCARP_TEST_THOROUGHLY)
  set(bits_points_full 40003)
endif()
set(bits_points ${bits_points_${speed}})

scarp_test_program(test_bits)
foreach(isa IN LISTS isas)
  if(NOT isa STREQUAL scalar)
    scarp_add_test(bits.${isa} bits test_bits ${isa} ${bits_points})
  endif()
endforeach()

# tests/mutants: a kernel file with a mistake of the kind that has been made before. The linker takes
# its table and leaves the library's own in the archive. test_bits must see each, but for those that
# are in grids.
function(scarp_mutant_program test isa mistake)
  set(target ${test}_${isa}_${mistake})
  add_executable(${target} ${test}.c mutants/kernels_${isa}.c)
  scarp_compile_rules(${target})
  scarp_library_rules(${target})
  string(TOUPPER MISTAKE_${mistake} definition)
  target_compile_definitions(${target} PRIVATE ${definition})
  if(SCARP_OPTIMIZE AND NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
    target_compile_options(${target} PRIVATE -O1) # compiles faster than at any other level
  endif()
  target_link_libraries(${target} PRIVATE scarp_internal)
endfunction()

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(mutant_isa avx2)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set(mutant_isa neon)
endif()
if(DEFINED mutant_isa)
  foreach(mistake fma lane tail)
    scarp_mutant_program(test_bits ${mutant_isa} ${mistake})
    scarp_add_test(bits.mutant.${mutant_isa}.${mistake} bits
                   test_bits_${mutant_isa}_${mistake} --must-differ ${mutant_isa} 259)
  endforeach()
endif()
