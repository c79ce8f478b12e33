#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer through pkg-config, as C and as C++; and scarp.pc where the directories are absolute.
. ./common.sh
[ -n "$pkg_config" ] || skip "no pkg-config"
[ -d "$prefix" ] || skip "nothing is installed"

fresh pkg_config
export PKG_CONFIG_LIBDIR="$prefix/$libdir/pkgconfig"
[ "$("$pkg_config" --modversion scarp)" = "$version" ] || fail "version"
static=
[ "$library_type" = SHARED_LIBRARY ] || static=--static

# consume NAME OPTION...
consume()
{
    name=$1
    shift
    # shellcheck disable=SC2046,SC2086 # words
    compile "$@" $("$pkg_config" --cflags scarp) consumer.c -x none -o "$dir/$name" \
        $("$pkg_config" --libs $static scarp) "-Wl,-rpath,$prefix/$libdir"
    run "$dir/$name"
}

consume c -std=c11 -x c
if compiles_cxx; then
    consume c++ -std=c++11 -x c++
else
    echo "no C++ compiler beside $c_compiler: C alone"
fi

# Absolute directories are taken as they are.
configure "$source_dir" "$dir/absolute" -DSCARP_BUILD_TESTS=OFF -DSCARP_BUILD_CLI=OFF \
    -DCMAKE_INSTALL_LIBDIR=/some/where/lib -DCMAKE_INSTALL_INCLUDEDIR=/else/where >/dev/null
# shellcheck disable=SC2046 # words
set -- $(PKG_CONFIG_LIBDIR="$dir/absolute" "$pkg_config" --cflags --libs --static scarp)
echo "absolute: $*"
[ "$*" = "-I/else/where -L/some/where/lib -lscarp -lm" ] || fail "absolute directories"
