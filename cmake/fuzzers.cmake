# SPDX-License-Identifier: MIT
# Compiles all that follows for libFuzzer, with checks of addresses and of undefined behaviour.

if(NOT CMAKE_C_COMPILER_ID STREQUAL "Clang" OR CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  message(FATAL_ERROR "SCARP_BUILD_FUZZERS needs clang, which has libFuzzer, and not ${CMAKE_C_COMPILER_ID}: -DCMAKE_C_COMPILER=clang")
endif()
if(BUILD_SHARED_LIBS OR NOT SCARP_BUILD_CLI)
  message(STATUS "Fuzz targets: the library is static, and the program is built")
  set(BUILD_SHARED_LIBS OFF)
  set(SCARP_BUILD_CLI ON)
endif()
set(SCARP_BUILD_BENCH OFF)
set(SCARP_INSTALL OFF)

set(sanitizers address,undefined,float-divide-by-zero)
# What is undefined traps: messages would double the time that the kernels take to compile.
set(fuzzer_flags -fsanitize=fuzzer-no-link,${sanitizers} -fno-sanitize-recover=all
    -fsanitize-trap=undefined,float-divide-by-zero -fno-omit-frame-pointer -g1)
include(CheckCSourceCompiles)
set(CMAKE_REQUIRED_FLAGS "-fsanitize=fuzzer,${sanitizers}")
set(CMAKE_REQUIRED_QUIET ON)
check_c_source_compiles("#include <stddef.h>
int LLVMFuzzerTestOneInput(const char *bytes, size_t size) { return bytes == NULL && size > 0; }" SCARP_HAS_LIBFUZZER)
unset(CMAKE_REQUIRED_FLAGS)
unset(CMAKE_REQUIRED_QUIET)
if(NOT SCARP_HAS_LIBFUZZER)
  message(FATAL_ERROR "SCARP_BUILD_FUZZERS: ${CMAKE_C_COMPILER} cannot link to libFuzzer (Debian: libclang-rt-19-dev)")
endif()
add_compile_options(${fuzzer_flags})
add_link_options(-fsanitize=${sanitizers})
