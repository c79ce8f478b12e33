# SPDX-License-Identifier: MIT
# Toolchain file: 64-bit Windows, by Debian's mingw-w64 gcc; programs run through wine. gcc has no
# kernels above SSE4.1 there: see src/dispatch/isas.h, and x86_64-w64-mingw32-clang.cmake.

set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# zlib is looked for among mingw's libraries alone.
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)

# Debian's `wine` prints advice about 32-bit programs with every start.
# In other locales than those of UTF-8, arguments would lose characters.
find_program(SCARP_WINE NAMES wine64 wine HINTS /usr/lib/wine)
mark_as_advanced(SCARP_WINE)
if(SCARP_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR env WINEDEBUG=-all LC_ALL=C.UTF-8 ${SCARP_WINE})
endif()
