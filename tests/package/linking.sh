#!/bin/sh
# SPDX-License-Identifier: MIT
# The lines of README.md that build and link, in a tree of its own and with an empty HOME. To be quick,
# the tree has the library of this build, and cmake does not build scarp there again.
. ./common.sh
[ -d "$prefix" ] || skip "nothing is installed"
[ "$library_type" = SHARED_LIBRARY ] || skip "the README's library is shared"
[ "$cross$emulator" = 0 ] || skip "programs run here"
[ "$libdir$includedir" = libinclude ] || skip "other installation directories were chosen"
! sanitized || skip "the README's commands do not sanitize"

fresh linking
mkdir -p "$dir/tree/build" "$dir/bin" "$dir/project"
home=$(mktemp -d) # shells split what pkg-config prints, so a home has no spaces
trap 'rm -rf "$home"' EXIT
cp -R "$source_dir/include" "$dir/tree"
ln -s "$(dirname "$library")" "$dir/tree/build/lib"
cat >"$dir/bin/cmake" <<EOF
#!/bin/sh
case "\$*" in
'-B build -DSCARP_BUILD_TESTS=OFF' | '--build build -j4') ;;
'--install build --prefix '*) mkdir -p "\$4" && cp -R '$prefix/.' "\$4" ;;
*) exec '$cmake' "\$@" ;;
esac
EOF
ln -s "$c_compiler" "$dir/bin/cc"
ln -s "$pkg_config" "$dir/bin/pkg-config"
chmod +x "$dir/bin/cmake"
env -i HOME="$home" PATH="$dir/bin:$PATH" sh readme_lines.sh "$source_dir/README.md" "$dir/tree" "$dir/project"
