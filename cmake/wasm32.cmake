# SPDX-License-Identifier: MIT
# Toolchain file: WebAssembly, by clang 19, with the C library of Debian's wasi-libc for the tests.
# These run in node; the modules of src/web need neither a C library nor a system.
#
# SCARP_WASM_SIMD=OFF leaves vectors out.

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SCARP_WASM_SIMD)

# Tests handle signals that never come. They need more than the 64 KiB of stack that is usual here.
set(CMAKE_C_FLAGS_INIT "-D_WASI_EMULATED_SIGNAL")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-lwasi-emulated-signal -Wl,--stack-first -Wl,-z,stack-size=1048576")
option(SCARP_WASM_SIMD "Build WebAssembly with vectors" ON)
if(SCARP_WASM_SIMD)
  string(APPEND CMAKE_C_FLAGS_INIT " -msimd128")
endif()

# Node 20 now and then crashes where a program ends while other threads still compile it.
set(CMAKE_CROSSCOMPILING_EMULATOR node --single-threaded --no-warnings
    --experimental-wasi-unstable-preview1 ${CMAKE_CURRENT_LIST_DIR}/wasi.mjs)
