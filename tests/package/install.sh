#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs into a prefix below the build tree, looks at what came out, and moves the prefix away:
# find_package.sh, pkg_config.sh and python.sh use it where it then is.
. ./common.sh

case $libdir$includedir in
/* | *//*) skip "absolute installation directories were chosen" ;;
esac
[ "$install_prefix" != /usr ] || skip "what is made for /usr does not move"

fresh install
"$cmake" --install "$build_dir" --config "$config" --prefix "$dir/prefix"
for file in "$includedir/scarp.h" "$includedir/scarp.hpp" "$includedir/scarp.glsl" \
    "$includedir/scarp.hlsl" "$includedir/scarp.wgsl" "$libdir/$library_name" "$libdir/pkgconfig/scarp.pc" \
    share/scarp/csharp/Scarp.cs "$libdir/cmake/scarp/scarpConfig.cmake" "$libdir/cmake/scarp/scarpConfigVersion.cmake"; do
    [ -f "$dir/prefix/$file" ] || fail "$file is not installed"
done

# A text that names the build, the sources or the first prefix would not survive the move.
# As a whole path: if the sources are in /scarp, lib/cmake/scarpConfig.cmake does not name them.
for place in "$build_dir" "$source_dir"; do
    pattern=$(printf '%s\n' "$place" | sed 's/[][\.*^$+?(){}|]/\\&/g')
    if grep -rIE "(^|[^[:alnum:]_.}]|-[IL])$pattern(/|[^[:alnum:]_]|\$)" "$dir/prefix"; then
        fail "what is installed names $place"
    fi
done

rm -rf "$prefix"
mkdir -p "$(dirname "$prefix")"
mv "$dir/prefix" "$prefix"

# The installed program, if there is one, finds its library in the new place.
if [ -x "$prefix/bin/scarp" ]; then
    run "$prefix/bin/scarp" --version
fi
