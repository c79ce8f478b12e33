#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer with scarp as a subdirectory: only the library is built, and nothing of it installed.
. ./common.sh

fresh add_subdirectory
configure . "$dir/build" -DSCARP_SOURCE="$source_dir"
build "$dir/build"
run "$dir/build/consumer"

"$cmake" --install "$dir/build" --config "$config" --prefix "$dir/prefix"
[ ! -e "$dir/prefix" ] || fail "installing the consumer installed scarp"
if "$cmake" --build "$dir/build" --config "$config" --target scarp_internal >/dev/null 2>&1; then
    fail "the tests are a part of the consumer's build"
fi
