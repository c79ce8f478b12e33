#!/bin/sh
# SPDX-License-Identifier: MIT
# The library without a build system: the command that the documentation gives.
. ./common.sh

fresh direct
cp -R "$source_dir/include" "$source_dir/src" consumer.c "$dir"
cd "$dir"
case $processor in
s390x) more=-fexcess-precision=fast ;; # see cmake/compile.cmake
*) more= ;;
esac
# shellcheck disable=SC2086 # words
"$c_compiler" $more -std=c11 -O2 -ffp-contract=off -Iinclude -c src/*.c src/scalar/*.c src/simd/*.c
"$c_compiler" -std=c11 -Iinclude consumer.c ./*.o -lm -o consumer
run ./consumer
