#!/bin/sh
# SPDX-License-Identifier: MIT
# The library without a build system: the command that cmake/README.md gives.
. ./common.sh

fresh direct
cp -R "$source_dir/include" "$source_dir/src" consumer.c "$dir"
cd "$dir"
case $processor in
s390x) more=-fexcess-precision=fast ;; # see cmake/compile.cmake
*) more= ;;
esac
# shellcheck disable=SC2016 # the backquotes are those of the README
arguments=$(sed -n 's/^ *`cc \(-std=c11 [^`]*-c src[^`]*\)`$/\1/p' "$source_dir/cmake/README.md")
[ -n "$arguments" ] || fail "cmake/README.md has no command that compiles src without a build system"
# shellcheck disable=SC2086 # words, and files by their patterns
# That it compiles and links is the question, and -O1 takes the least time.
"$c_compiler" $more $arguments -O1
"$c_compiler" -std=c11 -Iinclude consumer.c ./*.o -lm -o consumer
run ./consumer
