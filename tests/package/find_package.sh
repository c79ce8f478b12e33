#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer through find_package, and the versions that it may ask for.
. ./common.sh
[ -d "$prefix" ] || skip "nothing is installed"

fresh "find_package-$language"
configure_consumer . "$dir/build" -DCMAKE_PREFIX_PATH="$prefix" -DSCARP_VERSION="$version"
grep "^scarp_DIR:PATH=$prefix/" "$dir/build/CMakeCache.txt" || fail "found another scarp"
build "$dir/build"
run "$dir/build/consumer"

[ "$language" = C ] || exit 0
for wrong in 0.0.0 "${version%.*}.999" 999.0.0; do
    if configure_consumer . "$dir/wrong" -DCMAKE_PREFIX_PATH="$prefix" -DSCARP_VERSION="$wrong" \
        >"$dir/wrong.log" 2>&1; then
        fail "version $version serves find_package(scarp $wrong)"
    fi
    grep 'version: ' "$dir/wrong.log" || fail "not refused for its version: $(cat "$dir/wrong.log")"
    rm -rf "$dir/wrong"
done
