#!/bin/sh
# SPDX-License-Identifier: MIT
# The first line of both commands of the README says how long they take. A compiler that does not
# exist ends them right after.
. ./common.sh
fresh duration

first() # PRESET
{
    "$cmake" -S "$source_dir" --preset "$1" -B "$dir/$1" -G "$generator" \
        -DCMAKE_MAKE_PROGRAM="$make_program" -DCMAKE_C_COMPILER="$dir/none" >"$dir/log" 2>&1 || true
    grep '^-- ' "$dir/log" | sed -n '1p'
}
for preset in terrain test; do
    line=$(first $preset)
    echo "$preset: $line"
    case $line in
    *' takes '*' minute'*' on two cores') ;;
    *) fail "the preset $preset begins with: $line" ;;
    esac
done
