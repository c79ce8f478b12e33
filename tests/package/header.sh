#!/bin/sh
# SPDX-License-Identifier: MIT
# The header alone, strictly, in the oldest and newer standards of C and C++.
. ./common.sh

case $c_compiler_id in
GNU | *Clang) ;;
*) skip "no flags known for $c_compiler_id" ;;
esac

# Twice, for the include guard, and with what no language may lay out in its own way.
program()
{
    cat <<'EOF'
#include "scarp.h"
#include "scarp.h"
#define SAME(name, a, b) typedef char name[(a) == (b) ? 1 : -1]
SAME(noise_size, sizeof(struct scarp_noise), 192);
SAME(warp_offset, offsetof(struct scarp_noise, warp), 80);
SAME(plan_offset, offsetof(struct scarp_noise, plan), 80 + sizeof(void *));
SAME(plan_size, sizeof(struct scarp_plan), 12288);
SAME(samples_size, sizeof(struct scarp_samples), 16 * sizeof(float *));
SAME(grid_size, sizeof(struct scarp_grid), 192);
SAME(gpu_plan_size, sizeof(struct scarp_gpu_plan), 5376);
EOF
}

# check COMPILER LANGUAGE STANDARD FLAG...
check()
{
    compiler=$1 dialect=$2 standard=$3
    shift 3
    echo "$dialect, $standard $*"
    program |
        "$compiler" -x "$dialect" "-std=$standard" -I"$source_dir/include" -Wall -Wextra \
            -Wpedantic -Wconversion -Wundef -Wshadow -Werror "$@" -fsyntax-only -
}

if [ "$language" = C ]; then
    for standard in c99 c11 c17; do
        check "$c_compiler" c $standard -Wstrict-prototypes
    done
else
    for standard in c++11 c++14 c++17 c++20; do
        check "$cxx_compiler" c++ $standard -Wold-style-cast
    done
fi

# The layout where pointers have 32 bits, on processors that align doubles to 4 bytes and to 8, if
# the compiler knows them. That needs no C library, which may be missing.
for processor in -m32 --target=armv7-none-eabi; do
    if echo '' | "$c_compiler" -x c "$processor" -ffreestanding -fsyntax-only - 2>/dev/null; then
        check "$c_compiler" c c11 "$processor" -ffreestanding
    else
        echo "$c_compiler does not know $processor"
    fi
done
