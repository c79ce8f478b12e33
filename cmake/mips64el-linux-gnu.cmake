# SPDX-License-Identifier: MIT
# Toolchain file: 64-bit MIPS, by Debian's cross compiler; programs run through qemu.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR mips64el)
set(CMAKE_C_COMPILER mips64el-linux-gnuabi64-gcc)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-mips64el -L /usr/mips64el-linux-gnuabi64)
