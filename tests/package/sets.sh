#!/bin/sh
# SPDX-License-Identifier: MIT
# SCARP_SETS chooses kernel sets: a name that no set has stops configuring, and tests are there for
# scalar and the sets that are chosen. Without a choice, x86-64 has no generic.
. ./common.sh
fresh sets

if configure "$source_dir" "$dir/unknown" -DSCARP_SETS='avx2;avx3' >"$dir/log" 2>&1; then
    fail "a set avx3 is built"
fi
grep 'there is no kernel set avx3' "$dir/log" || fail "avx3 is not what stops it: $(cat "$dir/log")"

# expect SETS FOUND...: with these, there are tests for scalar and FOUND
expect()
{
    configure "$source_dir" "$dir/build" -DSCARP_SETS="$1" >"$dir/log" 2>&1 ||
        fail "cannot be configured: $(cat "$dir/log")"
    found=$("$ctest" --test-dir "$dir/build" -C "$config" -N | sed -n 's/^.*: golden[.]//p' | grep -vx frozen | sort)
    echo "$1:" "$found"
    shift
    [ "$found" = "$(printf '%s\n' "$@" scalar | sort)" ] || fail "$* are expected"
}
expect scalar
case $processor in
x86_64 | AMD64)
    expect '' avx2 avx512 sse4.1
    expect 'scalar;sse4.1;generic' generic sse4.1
    ;;
aarch64)
    expect '' generic neon
    expect neon neon
    ;;
esac
