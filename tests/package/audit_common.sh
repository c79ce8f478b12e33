# SPDX-License-Identifier: MIT
# What the audits of instructions share: settings as common.sh has them, which sets fuse, and the audit
# itself.
# shellcheck shell=sh disable=SC2034,SC2154

. ./common.sh
! sanitized || skip "sanitized code says nothing about the library"
case $config in
Debug) skip "code that is not optimised says nothing about the library" ;;
esac
exact='kernels_(avx2|avx512|neon)[.]c[.]o'
control_flags=
fusing= # the sets whose vf_exact_fma fuses
case $processor in
x86_64 | AMD64) control_flags=-mfma fusing='avx2 avx512' ;;
aarch64) fusing=neon ;;
riscv64) ;;
s390x) control_flags=-fexcess-precision=fast ;;
*) skip "no rules for $processor" ;;
esac
# Flags for one machine, or for whole programs, move instructions across files: then only the rules
# that hold for the whole library are checked.
files=1
case "$c_flags " in
*-march=* | *-mavx* | *-msse4* | *-flto* | *-m32*) files=0 ;;
esac

disassemble()
{
    "$objdump" -d --no-show-raw-insn "$@"
}

audit() # FILES [EXACT]
{
    awk -v processor="$processor" -v files="$1" -v exact="${2-}" -f audit.awk
}

disassemble_all() # LIST
{
    tr '\n' '\0' <"$1" | xargs -0 "$objdump" -d --no-show-raw-insn
}

# control RULE OBJECT [EXACT]: the audit reports RULE
control()
{
    if disassemble "$2" | audit 1 "${3-}" >"$dir/report" || ! grep -q "$1" "$dir/report"; then
        cat "$dir/report"
        fail "the audit does not report '$1'"
    fi
    echo "the audit finds: $(grep -c '' "$dir/report") x $1"
}
