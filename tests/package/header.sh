#!/bin/sh
# SPDX-License-Identifier: MIT
# The header alone, strictly, in the oldest and newer standards of C and C++.
. ./common.sh

case $c_compiler_id in
GNU | *Clang) ;;
*) skip "no flags known for $c_compiler_id" ;;
esac

# check COMPILER LANGUAGE STANDARD WARNING...; twice, for the include guard
check()
{
    compiler=$1 dialect=$2 standard=$3
    shift 3
    echo "$dialect, $standard"
    printf '#include "scarp.h"\n#include "scarp.h"\n' |
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
