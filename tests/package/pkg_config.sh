#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer through pkg-config; and scarp.pc where the directories are absolute.
. ./common.sh
[ -d "$prefix" ] || skip "nothing is installed"

fresh "pkg_config-$language"
export PKG_CONFIG_LIBDIR="$prefix/$libdir/pkgconfig"
[ "$("$pkg_config" --modversion scarp)" = "$version" ] || fail "version"

case $language in
C) set -- -std=c11 -x c ;;
CXX) set -- -std=c++11 -x c++ ;;
esac
# Its output is words as a shell reads them, but for parentheses.
asked() # OPTION
{
    "$pkg_config" "$1" scarp | sed 's/[()]/\\&/g'
}
eval "set -- \"\$@\" $(asked --cflags) consumer.c -x none -o \"\$dir/consumer\" $(asked --libs)"
compile "$@" "-Wl,-rpath,$prefix/$libdir"
run "$dir/consumer"

# Absolute directories are taken as they are, in whatever language. A static library says by itself
# that it needs libm.
[ "$language" = C ] || exit 0
for shared in ON OFF; do
    configure "$source_dir" "$dir/absolute" -DSCARP_BUILD_TESTS=OFF -DSCARP_BUILD_CLI=OFF \
        -DBUILD_SHARED_LIBS=$shared -DCMAKE_INSTALL_LIBDIR=/some/where/lib \
        -DCMAKE_INSTALL_INCLUDEDIR=/else/where >/dev/null
    static=
    [ $shared = OFF ] || static=--static
    # shellcheck disable=SC2046 # words
    set -- $(PKG_CONFIG_LIBDIR="$dir/absolute" "$pkg_config" --cflags --libs $static scarp)
    echo "absolute, shared $shared: $*"
    [ "$*" = "-I/else/where -L/some/where/lib -lscarp -lm" ] || fail "absolute directories"
done
