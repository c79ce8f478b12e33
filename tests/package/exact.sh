#!/bin/sh
# SPDX-License-Identifier: MIT
# Options that make compilers compute otherwise than the single file says are found at the first call,
# which then returns SCARP_ERROR_UNSUPPORTED; where a pragma of the file keeps them off, it has the golden
# bits. For gcc and every clang that is here.
. ./common.sh
! sanitized || skip "the objects of the library are sanitized already"
[ "$cross$emulator" = 0 ] || skip "the processor's own legs test its sets"
case $processor in
x86_64 | AMD64) ;;
*) skip "it is for x86-64, where a set fuses and another does not" ;;
esac
for feature in fma avx2; do
    grep -q "^flags.* $feature " /proc/cpuinfo 2>/dev/null || skip "the processor has no $feature"
done

fresh exact
"$cmake" -D "SOURCE=$source_dir" -D "OUTPUT=$dir" -D "VERSION=$version" \
    -P "$source_dir/cmake/single.cmake"
tests=$PWD
cd "$dir"

# compiled COMPILER OPTION...: the file with only AVX2, as ./refused
compiled()
{
    echo "$*"
    "$@" -std=c11 -O2 -w -DSCARP_AVX512=0 -DSCARP_SSE41=0 -I. -c scarp_single.c -o scarp.o
    "$1" -std=c11 -O1 -I. "$tests/refused.c" scarp.o -lm -o refused
}

# The same without a set, whose kernels take long to compile
plain()
{
    compiled "$@" -DSCARP_AVX2=0
}

tried=0
for compiler in clang-14 clang-19 clang; do
    command -v $compiler >/dev/null || continue
    [ $compiler != clang ] || [ $tried = 0 ] || continue
    tried=$((tried + 1))
    if [ $compiler != clang-14 ]; then
        compiled $compiler -ffp-contract=fast
        run ./refused refused
        run ./refused served scalar # nothing is fused without FMA
    fi
    plain $compiler -ffp-contract=fast -mfma
    run ./refused refused
    plain $compiler -ffp-contract=off -mfma
    run ./refused served
    # Parts of -ffast-math that no macro shows
    for option in "-fassociative-math -fno-signed-zeros -fno-trapping-math" -freciprocal-math -fno-signed-zeros; do
        # shellcheck disable=SC2086 # words
        plain $compiler -ffp-contract=off $option
        run ./refused refused
    done
done
if command -v gcc >/dev/null; then
    tried=$((tried + 1))
    compiled gcc -ffp-contract=fast -mfma
    run ./refused served
    gcc -std=c11 -O1 -ffp-contract=off -I. "$tests/../test_golden.c" scarp.o -lm -o test_golden
    unset SCARP_REQUIRE_ISAS # this file has two sets
    run ./test_golden "$tests/../golden.txt" avx2
    run ./test_golden "$tests/../golden.txt" scalar
fi
[ $tried -gt 0 ] || skip "there is neither gcc nor clang"
