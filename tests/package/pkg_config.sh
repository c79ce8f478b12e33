#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer through pkg-config; and scarp.pc where the directories are absolute.
. ./common.sh
[ -d "$prefix" ] || skip "nothing is installed"

fresh "pkg_config-$language"
export PKG_CONFIG_LIBDIR="$prefix/$libdir/pkgconfig"
[ "$("$pkg_config" --modversion scarp)" = "$version" ] || fail "version"
static=
[ "$library_type" = SHARED_LIBRARY ] || static=--static

case $language in
C) set -- -std=c11 -x c ;;
CXX) set -- -std=c++11 -x c++ ;;
esac
# shellcheck disable=SC2046,SC2086 # words
compile "$@" $("$pkg_config" --cflags scarp) consumer.c -x none -o "$dir/consumer" \
    $("$pkg_config" --libs $static scarp) "-Wl,-rpath,$prefix/$libdir"
run "$dir/consumer"

# Absolute directories are taken as they are, in whatever language.
[ "$language" = C ] || exit 0
configure "$source_dir" "$dir/absolute" -DSCARP_BUILD_TESTS=OFF -DSCARP_BUILD_CLI=OFF \
    -DCMAKE_INSTALL_LIBDIR=/some/where/lib -DCMAKE_INSTALL_INCLUDEDIR=/else/where >/dev/null
# shellcheck disable=SC2046 # words
set -- $(PKG_CONFIG_LIBDIR="$dir/absolute" "$pkg_config" --cflags --libs --static scarp)
echo "absolute: $*"
[ "$*" = "-I/else/where -L/some/where/lib -lscarp -lm" ] || fail "absolute directories"
