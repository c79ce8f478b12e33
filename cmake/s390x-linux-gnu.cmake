# SPDX-License-Identifier: MIT
# Toolchain file: IBM Z, which is big-endian (generic kernels), by Debian's cross compiler;
# programs run through qemu.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR s390x)
set(CMAKE_C_COMPILER s390x-linux-gnu-gcc)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-s390x -L /usr/s390x-linux-gnu)
