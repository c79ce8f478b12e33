# SPDX-License-Identifier: MIT
# Scarp.cs, by Mono. It loads no library with instruments in it, nor one of another processor.

scarp_add_test(csharp csharp IN without-mono NEEDS mono posix python3
               COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/bindings/test_csharp.py
               ${PROJECT_SOURCE_DIR} ${SCARP_MCS} ${SCARP_MONO} $<TARGET_FILE:scarp>
               $<TARGET_FILE:bindings_hashes> ${CMAKE_CURRENT_BINARY_DIR}/csharp)

# The figures of its README: from C, and by `test_csharp.py ... overhead ...` from C#
add_executable(bindings_overhead EXCLUDE_FROM_ALL bindings/overhead.c)
scarp_compile_rules(bindings_overhead)
target_link_libraries(bindings_overhead PRIVATE scarp ${SCARP_LIBM})
