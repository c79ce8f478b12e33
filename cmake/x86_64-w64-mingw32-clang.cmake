# SPDX-License-Identifier: MIT
# Toolchain file: 64-bit Windows, by clang with the headers and libraries of Debian's mingw-w64. It
# aligns its stack for wide vectors, which gcc does not, so all kernel sets of x86 are built.

include(${CMAKE_CURRENT_LIST_DIR}/x86_64-w64-mingw32.cmake)
find_program(SCARP_CLANG NAMES clang-19 clang REQUIRED)
mark_as_advanced(SCARP_CLANG)
set(CMAKE_C_COMPILER ${SCARP_CLANG})
set(CMAKE_C_COMPILER_TARGET x86_64-w64-windows-gnu)
