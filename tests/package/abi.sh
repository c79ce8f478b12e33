#!/bin/sh
# SPDX-License-Identifier: MIT
# The binary interface has what abi.xml says: functions, structures, enumerators. More functions, or
# enumerators at the end, break no program. gcc describes the public functions; the kernels, which
# nobody sees, are not compiled.
#
#     abi.sh SETTINGS           compares
#     abi.sh SETTINGS same      compares, and what was added counts, too
#     abi.sh SETTINGS renew     writes abi.xml anew
. ./common.sh
[ "$processor$system" = x86_64Linux ] || skip "abi.xml is of x86-64 and Linux"
[ "$c_compiler_id" = GNU ] || skip "abi.xml is of gcc; other compilers describe types differently"
! sanitized || skip "sanitizers add to what is described"

fresh abi
here=$PWD
cd "$dir"
"$c_compiler" -std=c11 -g -O0 -fPIC -fvisibility=hidden -DSCARP_BUILDING_SHARED \
    -ffile-prefix-map="$source_dir/=" \
    -I"$source_dir/include" -shared "-Wl,-soname,libscarp.so.$abi" "-Wl,--version-script=$map" \
    "$source_dir"/src/calls/*.c "$source_dir"/src/plan/*.c "$source_dir"/src/dispatch/*.c \
    "$source_dir"/src/recipe/*.c -o libscarp.so
options='--exported-interfaces-only --drop-private-types --no-corpus-path --no-comp-dir-path'
options="$options --no-show-locs --no-elf-needed --no-architecture"
# shellcheck disable=SC2086 # words
"$abidw" $options --type-id-style hash --headers-dir "$source_dir/include" libscarp.so >found.xml
if [ "${2-}" = renew ]; then
    cp found.xml "$here/abi.xml"
    echo "abi.xml is what the sources say"
    exit 0
fi

# abidiff's status is bits: 1 and 2 errors, 4 a change, 8 a change that breaks programs.
status=0 additions=--no-added-syms
[ "${2-}" != same ] || additions=
# shellcheck disable=SC2086 # a word or none
"$abidiff" $additions "$here/abi.xml" found.xml >report 2>&1 || status=$?
cat report
[ $status -ne 0 ] || exit 0
[ $((status & 3)) = 0 ] || fail "abidiff cannot compare"
fail "the binary interface is not that of abi.xml. If the change is meant, see \"To change the binary
interface\" in src/README.md"
