#!/bin/sh
# SPDX-License-Identifier: MIT
# The archive that cpack makes has everything, and works where it is unpacked.
. ./common.sh
[ "$install_prefix" != /usr ] || skip "where the prefix is /usr, packages are Debian's"
case $libdir$includedir in
/* | *//*) skip "absolute installation directories were chosen" ;;
esac

fresh archive
# cpack would build all targets first if it knew that there are Makefiles.
"$cpack" --config "$build_dir/CPackConfig.cmake" -G TGZ -B "$dir" -C "$config" \
    -D CPACK_CMAKE_GENERATOR=Ninja
cd "$dir"
set -- scarp-"$version"-*.tar.gz
[ -f "$1" ] || fail "no archive: $*"
"$cmake" -E tar xzf "$1"
top=$dir/${1%.tar.gz}
[ -d "$top" ] || fail "$1 does not unpack into $top"
for file in "$includedir/scarp.h" "$includedir/scarp.hpp" "$includedir/scarp.wgsl" \
    "$libdir/$library_name" "$libdir/pkgconfig/scarp.pc" "$libdir/cmake/scarp/scarpConfig.cmake" \
    share/scarp/scarp_single.c share/scarp/scarp.h share/scarp/csharp/Scarp.cs share/doc/scarp/LICENSE; do
    [ -f "$top/$file" ] || fail "$file is not in the archive"
done
cmp "$top/$includedir/scarp.h" "$top/share/scarp/scarp.h"
# The same sources give the same bytes, wherever the build directory is.
if [ "$config" = Release ] && grep -rlsF "$build_dir" "$build_dir/bin/scarp" "$library" "$top"; then
    fail "these name the build directory"
fi
if [ -e "$top/bin/scarp" ]; then
    run "$top/bin/scarp" --version
fi
cd "$OLDPWD"
configure_consumer . "$dir/build" -DCMAKE_PREFIX_PATH="$top" -DSCARP_VERSION="$version"
grep "^scarp_DIR:PATH=$top/" "$dir/build/CMakeCache.txt" || fail "found another scarp"
build "$dir/build"
run "$dir/build/consumer"
