#!/bin/sh
# SPDX-License-Identifier: MIT
# Instructions: what the audit in audit.awk forbids is not in the library. First the audit must find
# each of these things in objects that are made to have them.
. ./audit_common.sh

fresh audit
# The kernels under a wrong name: the library's own, which saves seconds, unless flags change them.
misplaced() # NAME OBJECT
{
    if [ $files = 1 ]; then
        cp "$(grep "$1\\.c\\.o" "$objects")" "$dir/$2"
    else
        "$c_compiler" -std=c11 -O2 -I"$source_dir/include" -ffp-contract=off \
            -c "$source_dir/src/simd/$1.c" -o "$dir/$2"
    fi
}
# has SET: this build has its kernels
has()
{
    case ";$sets;" in
    ';;' | *";$1;"*) true ;;
    *) false ;;
    esac
}
echo 'float f(float a, float b, float c) { return a * b + c; }' >"$dir/fused.c"
# shellcheck disable=SC2086 # words
"$c_compiler" -O2 -ffp-contract=fast $control_flags -c "$dir/fused.c" -o "$dir/fused.o"
control 'fused multiply-add' "$dir/fused.o"
cp "$dir/fused.o" "$dir/kernels_avx2.c.o"
control 'fused multiply-add' "$dir/kernels_avx2.c.o" "$exact" # not packed
case $processor in
x86_64 | AMD64)
    control 'AVX outside its kernels' "$dir/fused.o"
    if has avx512; then
        misplaced kernels_avx512 kernels_avx2.c.o
        control 'AVX-512 in the AVX2 kernels' "$dir/kernels_avx2.c.o"
    fi
    if has sse4.1; then
        misplaced kernels_sse41 plan.c.o
        control 'SSE4.1 outside its kernels' "$dir/plan.c.o"
    fi
    echo '#include <xmmintrin.h>
        __m128 f(__m128 x) { return _mm_rsqrt_ps(x); }' >"$dir/estimate.c"
    ;;
aarch64)
    echo '#include <arm_neon.h>
        float32x4_t f(float32x4_t x) { return vrsqrteq_f32(x); }' >"$dir/estimate.c"
    ;;
esac
if [ -e "$dir/estimate.c" ]; then
    "$c_compiler" -O2 -c "$dir/estimate.c" -o "$dir/estimate.o"
    control 'estimate' "$dir/estimate.o"
fi

disassemble_all "$objects" >"$dir/objects.s"
audit $files "$exact" <"$dir/objects.s" || fail "in the objects"
disassemble "$library" | audit 0 . || fail "in the library"
if [ $files = 1 ] && [ "$control_flags" = -mfma ]; then
    for width in kernels_avx2:ymm kernels_avx512:zmm; do
        has "$(expr "$width" : 'kernels_\(.*\):')" || continue
        awk -v object="${width%:*}" -v name="%${width#*:}" '
            /file format/ { here = index($0, object) }
            here && index($0, name) { found = 1 }
            END { exit !found }' "$dir/objects.s" ||
            fail "no ${width#*:} register in ${width%:*}: is this the library?"
    done
fi
