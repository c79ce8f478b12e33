#!/bin/sh
# SPDX-License-Identifier: MIT
# The library as one file: compiled by the command in it, it gives the golden bits with
# all its sets; flags that would change bits do not, or are refused.
. ./common.sh
! sanitized || skip "the objects of the library are sanitized already"
[ "$cross$emulator" = 0 ] || skip "the processor's own legs test its sets"
case $c_compiler_id in
GNU | *Clang) ;;
*) skip "it is for gcc and clang" ;;
esac

fresh single
"$cmake" -D "SOURCE=$source_dir" -D "OUTPUT=$dir" -D "VERSION=$version" \
    -P "$source_dir/cmake/single.cmake"
tests=$PWD/..
cd "$dir"
grep -q "scarp $version in one file" scarp_single.c || fail "it does not say its version"
grep -q 'Permission is hereby granted' scarp_single.c || fail "it has no licence"
if grep -n "$source_dir" scarp_single.c; then
    fail "it names the source tree"
fi

# What is before the sources, with a sum that the flags would fuse.
sed '/^#include <float.h>/,$d' scarp_single.c >fused.c
echo 'float f(float a, float b, float c) { return a * b + c; }
#endif' >>fused.c
case $processor in
x86_64 | AMD64) fma=-mfma ;;
*) fma= ;;
esac
case $c_compiler_id in
GNU) contract=fast ;;
*) contract=on ;; # the default; clang's fast disregards what sources say
esac
# shellcheck disable=SC2086 # words
"$c_compiler" -std=gnu11 -O2 $fma -ffp-contract=$contract -c fused.c
if [ -n "$objdump" ] && "$objdump" -d --no-show-raw-insn fused.o | grep -E 'fn?m(add|la)'; then
    fail "-ffp-contract=$contract fuses"
fi
if "$c_compiler" -std=c11 -ffast-math -fsyntax-only scarp_single.c 2>fast.log; then
    fail "-ffast-math is not refused"
fi
grep -q 'fno-fast-math' fast.log || fail "not refused for -ffast-math: $(cat fast.log)"

# shellcheck disable=SC2086 # a word or none
"$c_compiler" -std=c11 -O2 -ffp-contract=off -Wall -Wextra -Wpedantic $werror -c scarp_single.c
for program in test_golden test_bits test_fpmode; do
    "$c_compiler" -std=c11 -O1 -ffp-contract=off -I. "$tests/$program.c" scarp_single.o -lm \
        -o $program
done

# can SET...: whether the command ran, and did not skip the set
can()
{
    status=0
    "$@" >log 2>&1 || status=$?
    tail -n 1 log
    case $status in
    0) true ;;
    77) false ;;
    *) fail "$*: $(cat log)" ;;
    esac
}

served=
for set in scalar sse4.1 avx2 avx512 neon generic; do
    can ./test_golden "$tests/golden.txt" $set || continue
    served="$served $set"
    can ./test_fpmode $set
    [ $set = scalar ] || can ./test_bits $set 259 7
done
echo "sets:$served"
case $served in
*scalar?*) ;;
*) fail "too few sets" ;;
esac
