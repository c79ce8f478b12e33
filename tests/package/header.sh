#!/bin/sh
# SPDX-License-Identifier: MIT
# The header alone, strictly, in the oldest and newer standards of C and C++.
. ./common.sh

case $c_compiler_id in
GNU | *Clang) ;;
*) skip "no flags known for $c_compiler_id" ;;
esac

# check LANGUAGE STANDARD WARNING...; twice, for the include guard
check()
{
    language=$1 standard=$2
    shift 2
    echo "$language, $standard"
    printf '#include "scarp.h"\n#include "scarp.h"\n' |
        "$c_compiler" -x "$language" "-std=$standard" -I"$source_dir/include" -Wall -Wextra \
            -Wpedantic -Wconversion -Wundef -Wshadow -Werror "$@" -fsyntax-only -
}

for standard in c99 c11 c17; do
    check c $standard -Wstrict-prototypes
done
if compiles_cxx; then
    for standard in c++11 c++20; do
        check c++ $standard -Wold-style-cast
    done
else
    echo "no C++ compiler beside $c_compiler: C alone"
fi
