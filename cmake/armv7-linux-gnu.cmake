# SPDX-License-Identifier: MIT
# Toolchain file: 32-bit Arm with NEON, by Debian's cross compiler; programs run through qemu. Its
# vectors flush denormals, so only the scalar set gives the promised bits there.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_C_FLAGS_INIT "-march=armv7-a -mfpu=neon")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm -L /usr/arm-linux-gnueabihf)
