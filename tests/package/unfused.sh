#!/bin/sh
# SPDX-License-Identifier: MIT
# vf_exact_fma of src/simd/vec.h is the only operation that may fuse: the kernels compiled once more
# without it have nothing fused.
. ./audit_common.sh
[ -n "$fusing" ] || skip "no kernels fuse on $processor"

fresh unfused
for set in $fusing; do
    control 'fused multiply-add' "$(grep "kernels_$set\\.c\\.o" "$objects")"
done
[ "$(grep -cE "$exact" "$unfused_objects")" = "$(grep -cE "$exact" "$objects")" ] ||
    fail "not all kernels that fuse are there without vf_exact_fma"
disassemble_all "$unfused_objects" | audit $files || fail "in the kernels without vf_exact_fma"
