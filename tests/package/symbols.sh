#!/bin/sh
# SPDX-License-Identifier: MIT
# Symbols: the library exports what scarp.h declares, keeps to its prefix, and
# asks for nothing but a few functions of libc and libm.
. ./common.sh
[ "$system" = Linux ] || skip "written for ELF"

fresh symbols
tr '\n' ' ' <"$source_dir/include/scarp.h" | sed 's/SCARP_API/\n&/g' |
    sed -n 's/^SCARP_API [^(]*[ *]\(scarp_[a-z0-9_]*\)(.*/\1/p' | sort >"$dir/expected"

# same WHAT: the list on stdin is the expected one
same()
{
    sort >"$dir/found"
    diff "$dir/expected" "$dir/found" || fail "$1 (>) differs from what scarp.h declares (<)"
}

if [ "$library_type" = SHARED_LIBRARY ]; then
    # Calls that are added from 1.0 on have nodes of their own: SCARP_1.n.
    "$nm" -D --defined-only "$library" | awk -v node="SCARP_$abi" '
        $2 == "A" { next } # the nodes
        {
            at = index($3, "@@" node)
            after = substr($3, at + length(node) + 2)
            print at && (after == "" || after ~ /^[.]/) ? substr($3, 1, at - 1) : $3
        }' | same "what the library exports in a node SCARP_$abi"
    "$objdump" -p "$library" | grep -E "^ *SONAME +libscarp.so.$abi\$" ||
        fail "the SONAME is not libscarp.so.$abi"
fi

# Names that compilers and sanitizers add: positions, stack protection, atomics, instrumentation, and
# clang's for a memcmp() that is compared with 0.
added='_GLOBAL_OFFSET_TABLE_|bcmp|__x86\..*|__stack_chk_.*|__aarch64_.*|__gcov_.*'
added="$added|_?__(odr_)?[atu]?[a-z]*san_.*|__sanitizer_.*|__odr_asan.*"
needed='mem(cpy|set|move|cmp)|str(cmp|ncmp|len)|floorf?|sqrtf?|fe[gs]etround'

# The objects, so that static and shared libraries are looked at in the same way.
tr '\n' '\0' <"$objects" | xargs -0 "$nm" -g >"$dir/symbols"
awk 'NF == 3 { print $3 }' "$dir/symbols" | sort -u >"$dir/defined"
awk 'NF == 2 && $1 == "U" { print $2 }' "$dir/symbols" | sort -u >"$dir/undefined"
grep -q scarp_sample2 "$dir/defined" || fail "nm found no symbols"
grep '^scarp_' "$dir/defined" | same "what the objects define besides internal functions"
if grep -Ev "^(scarpi?_.*|$added)\$" "$dir/defined"; then
    fail "global symbols without the prefix scarp_, or scarpi_ for internal functions"
fi
if grep -Ev "^(scarpi?_.*|$needed|$added)\$" "$dir/undefined"; then
    fail "the library asks for more than it should"
fi
