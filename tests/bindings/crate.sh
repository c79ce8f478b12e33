#!/bin/sh
# SPDX-License-Identifier: MIT
# The crate as a package; and build.rs, which compiles the library or finds that of the system.
#
#     crate.sh SETTINGS CARGO
#
# Settings are those of ../package/common.sh. The compiled libraries have few kernel sets, to be
# built in seconds.
set -eu
. "$1"
cargo=$2
unset SCARP_LIB_DIR SCARP_BUILD CFLAGS
dir=$scratch/crate
rm -rf "$dir"
mkdir -p "$dir/unpacked" "$dir/pkgconfig"

fail()
{
    echo "FAILED: $*"
    exit 1
}

# refused TEXT COMMAND...: whether the command fails and says so
refused()
{
    text=$1
    shift
    if "$@" >"$dir/log" 2>&1; then
        fail "not refused: $*"
    fi
    grep -q -e "$text" "$dir/log" || fail "not refused for '$text': $(cat "$dir/log")"
}

echo "the package"
"$cmake" -D "SOURCE=$source_dir" -D "OUTPUT=$dir/single" -D "VERSION=$version" \
    -P "$source_dir/cmake/single.cmake" >/dev/null
"$cmake" -D "SOURCE=$source_dir" -D "SINGLE=$dir/single" -D "OUTPUT=$dir/crate" \
    -D REPOSITORY=https://example.org/scarp.git -P "$source_dir/cmake/crate.cmake"
cd "$dir/crate"
grep -q '^repository = "https://example.org/scarp.git"$' Cargo.toml || fail "it has no repository"
! grep -q repository "$source_dir/src/bindings/rust/Cargo.toml" || fail "the tree has an address"
"$cargo" package --offline --allow-dirty --list | tee "$dir/list"
for file in Cargo.toml LICENSE README.md build.rs c/scarp.h c/scarp_single.c \
    examples/hillshade.rs presets/alps.recipe src/ffi.rs tests/hashes.rs; do
    grep -qxF "$file" "$dir/list" || fail "it lacks $file"
done
"$cargo" package --offline --allow-dirty --no-verify
tar -xzf "$CARGO_TARGET_DIR/package/scarp-$version.crate" -C "$dir/unpacked"
cd "$dir/unpacked/scarp-$version"
ls -l c/scarp_single.c

# What a program of this crate is linked to: `shared` or `static`
linked()
{
    program=$(find "$CARGO_TARGET_DIR/debug/deps" -name 'hashes-*' -perm -u+x -type f | head -n 1)
    case $(ldd "$program") in
    *libscarp*) echo shared ;;
    *) echo static ;;
    esac
}

echo "compiled from the package, with its examples"
export CARGO_TARGET_DIR="$dir/target"
export CC="$c_compiler" SCARP_BUILD=source
export CFLAGS="-O1 -DSCARP_AVX512=0 -DSCARP_AVX2=0 -DSCARP_GENERIC=0 -ffast-math -ffp-contract=fast"
"$cargo" test --offline --tests
[ "$(linked)" = static ] || fail "the library is not inside"
"$cargo" run --offline --example hillshade -- 60 40 3
[ "$(head -c 9 hillshade.pgm | tr '\n' ' ')" = "P5 60 40 " ] || fail "no picture"
[ "$(wc -c <hillshade.pgm)" = 2413 ] || fail "a picture of another size"

echo "compiled from the tree"
cd "$source_dir/src/bindings/rust"
rm -rf "$CARGO_TARGET_DIR"
"$cargo" test --offline --locked --test hashes
[ "$(linked)" = static ] || fail "the library is not inside"

echo "another static library in the same place"
mkdir "$dir/static"
cp "$(find "$CARGO_TARGET_DIR" -name libscarp.a | head -n 1)" "$dir/static"
SCARP_BUILD='' SCARP_LIB_DIR=$dir/static "$cargo" build --offline --locked
sleep 1
touch "$dir/static/libscarp.a"
SCARP_BUILD='' SCARP_LIB_DIR=$dir/static "$cargo" build --offline --locked >"$dir/log" 2>&1
grep -q Compiling "$dir/log" || fail "the crate keeps the old library: $(cat "$dir/log")"

echo "mistakes are told"
CC=/nowhere/cc refused /nowhere/cc "$cargo" build --offline --locked
SCARP_BUILD=both refused "SCARP_BUILD is source or system" "$cargo" build --offline --locked
unset SCARP_BUILD
SCARP_LIB_DIR=$dir refused "there is no library scarp" "$cargo" build --offline --locked

echo "the library of the system, if its version serves"
export PKG_CONFIG="$pkg_config" PKG_CONFIG_LIBDIR="$dir/pkgconfig" SCARP_BUILD=system
for other in 0.1.9 0.3.0 1.0.0; do
    printf 'Name: scarp\nDescription: noise\nVersion: %s\nLibs: -lscarp\n' $other \
        >"$dir/pkgconfig/scarp.pc"
    refused "pkg-config knows no scarp of this version" "$cargo" build --offline --locked
done
if [ "$library_type" = SHARED_LIBRARY ]; then
    sed "s/^Version.*/Version: $version/; s|^Libs.*|Libs: -L$(dirname "$library") -lscarp|" \
        "$dir/pkgconfig/scarp.pc" >"$dir/scarp.pc"
    mv "$dir/scarp.pc" "$dir/pkgconfig"
    rm -rf "$CARGO_TARGET_DIR"
    "$cargo" test --offline --locked --test hashes
    [ "$(linked)" = shared ] || fail "pkg-config's library is not linked"
fi
