#!/bin/bash
# SPDX-License-Identifier: MIT
# Makes the parts of a release once, out of the tree that this file lies in, which has to be an unpacked
# source archive: nothing is taken from git.
#
#   SOURCE_DATE_EPOCH=SECONDS cmake/release/pack.sh PARTS OUTPUT SCRATCH
#
# PARTS have commas between them: archive, deb, single, wheel, crate, npm, playground, csharp, shaders.
# OUTPUT gets the artifacts. SCRATCH is for what is built, and gets three lists for describe.py: `tools`,
# `libraries` and `left_out`. SCARP_REQUIRE_ALL, SCARP_REPOSITORY, SCARP_CONTACT and JOBS in the environment
# are the options of ../release.sh.
set -eu -o pipefail
source=$(cd "$(dirname "$0")/../.." && pwd -P)
parts=$1
output=$(cd "$2" && pwd -P)
scratch=$(cd "$3" && pwd -P)
version=$(sed -nE 's/^#define SCARP_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' "$source/include/scarp.h" | paste -sd .)
export SOURCE_DATE_EPOCH CMAKE_BUILD_PARALLEL_LEVEL="${JOBS:-1}"
umask 022
exec </dev/null 3>&2
for list in tools libraries left_out; do
    : >"$scratch/$list"
done

# What the parts need: programs, of which ldd tells the version of libc; headers and libraries that are tried
native='system cmake cc ld ldd make strip zlib'
declare -A needs=(
    [archive]="$native objdump"
    [deb]="$native dpkg-deb dpkg-shlibdeps file gzip"
    [single]=cmake
    [wheel]="$native objdump python3"
    [crate]='cmake cargo'
    [npm]='system cmake make clang-19 wasm-ld-19 wasi-libc node npm'
    [playground]='system cmake make clang-19 wasm-ld-19 wasi-libc node npm'
    [csharp]='tar gzip'
    [shaders]='tar gzip')

has() # TOOL
{
    case $1 in
    cc) command -v "${CC:-cc}" ;;
    zlib) echo '#include <zlib.h>' | "${CC:-cc}" -E - ;;
    system) [ -r /etc/os-release ] ;;
    wasi-libc) echo 'int main(void) { return 0; }' | clang-19 --target=wasm32-wasi -x c - -o "$scratch/try.wasm" ;;
    *) command -v "$1" ;;
    esac >/dev/null 2>&1
}

# The line by which a tool tells its version
version_line() # TOOL
{
    local -x LC_ALL=C # some tools translate theirs
    case $1 in
    cc) "${CC:-cc}" --version ;;
    zlib) echo "zlib $(printf '#include <zlib.h>\nZLIB_VERSION\n' | "${CC:-cc}" -E - | tail -n 1 | tr -d '"')" ;;
    system) sed -n 's/^PRETTY_NAME="\(.*\)"$/\1/p' /etc/os-release ;;
    wasi-libc) echo "wasi-libc $(dpkg-query -W -f '${Version}' wasi-libc 2>/dev/null || echo unknown)" ;;
    node | npm) echo "$1 $("$1" --version)" ;;
    python3) python3 -c 'import platform, zlib; print("python3 (zlib %s) %s" % (zlib.ZLIB_RUNTIME_VERSION, platform.python_version()))' ;;
    *) "$1" --version ;;
    esac 2>&1 | sed -n '/./{p;q}'
}

leave_out() # PART TEXT
{
    printf '%s\t%s\n' "$1" "$2" >>"$scratch/left_out"
    echo "    $1 is left out: $2" >&3
    [ -z "${SCARP_REQUIRE_ALL-}" ] || exit 1
}

library() # PART NAME VERSION
{
    printf '%s\t%s\t%s\n' "$@" >>"$scratch/libraries"
}

# $output/NAME.tar.gz of $scratch/NAME
archive()
{
    tar --sort=name --format=ustar --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
        --mode=u=rwX,go=rX -cf - -C "$scratch" "$1" | gzip -9n >"$output/$1.tar.gz"
}

# The newest glibc that the files ask for
glibc_of() # FILE...
{
    objdump -T "$@" | sed -n 's/.*GLIBC_\([0-9.]*\).*/\1/p' | sort -Vu | tail -n 1
}

build=$scratch/build

# native PREFIX: builds the library and the program for this prefix; it is compiled once.
native()
{
    cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="${CC:-cc}" -DCMAKE_INSTALL_PREFIX="$1" \
        -DSCARP_BUILD_TESTS=OFF -DSCARP_BUILD_BENCH=OFF ${SCARP_CONTACT:+-DCPACK_PACKAGE_CONTACT="$SCARP_CONTACT"}
    cmake --build "$build"
}

make_archive()
{
    native /usr/local
    (cd "$build" && cpack)
    cp "$build"/scarp-"$version"-*.tar.gz "$output"
    library archive glibc "$(glibc_of "$build/bin/scarp" "$build"/lib/libscarp.so)"
    library archive zlib "$(version_line zlib | sed 's/.* //')"
}

make_deb()
{
    native /usr
    (cd "$build" && cpack)
    cp "$build"/*.deb "$output"
    library deb glibc "$(glibc_of "$build/bin/scarp" "$build"/lib/libscarp.so)"
    library deb zlib "$(version_line zlib | sed 's/.* //')"
}

single()
{
    [ -f "$scratch/single/scarp_single.c" ] || cmake -D SOURCE="$source" -D OUTPUT="$scratch/single" \
        -D VERSION="$version" -P "$source/cmake/single.cmake"
}

make_single()
{
    single
    cp -R "$scratch/single" "$scratch/scarp-$version-single"
    archive "scarp-$version-single"
}

# The stripped library, with the name of the oldest platform that has what it needs. Indices of packages
# take no wheel of just "linux".
make_wheel()
{
    local library glibc platform=''
    native /usr/local
    cmake --install "$build" --strip --component library --prefix "$scratch/installed"
    library=$(find "$scratch/installed" -name 'libscarp.so.*' -type f)
    glibc=$(glibc_of "$library")
    [ -z "$glibc" ] || platform=manylinux_$(sed -E 's/^([0-9]+)\.([0-9]+).*/\1_\2/' <<<"$glibc")_$(uname -m)
    python3 -B "$source/src/bindings/python/wheel.py" "$library" "$output" ${platform:+"$platform"}
    library wheel glibc "$glibc"
}

make_crate()
{
    single
    cmake -D SOURCE="$source" -D SINGLE="$scratch/single" -D OUTPUT="$scratch/crate" \
        -D REPOSITORY="${SCARP_REPOSITORY-}" -P "$source/cmake/crate.cmake"
    (cd "$scratch/crate" && CARGO_TARGET_DIR=$scratch/cargo cargo package --offline --allow-dirty --no-verify)
    cp "$scratch/cargo/package/scarp-$version.crate" "$output"
}

web() # TARGET
{
    cmake -S "$source" -B "$scratch/web" -DCMAKE_TOOLCHAIN_FILE="$source/cmake/wasm32.cmake" -DCMAKE_BUILD_TYPE=Release \
        -DBUILD_SHARED_LIBS=OFF -DSCARP_BUILD_CLI=OFF -DSCARP_BUILD_BENCH=OFF -DSCARP_BUILD_TESTS=OFF \
        -DSCARP_INSTALL=OFF -DSCARP_REPOSITORY="${SCARP_REPOSITORY-}"
    cmake --build "$scratch/web" --target "$1"
}

make_npm()
{
    web npm
    (cd "$scratch/web/npm" && chmod 644 ./*.wasm &&
        npm pack --offline --ignore-scripts --loglevel=error --cache "$scratch/npm" --pack-destination "$output")
    library npm wasi-libc "$(version_line wasi-libc | sed 's/.* //')"
}

# npm fetches the libraries of the page, those of src/web/playground/package-lock.json.
make_playground()
{
    local name=scarp-playground-$version
    web playground
    if [ ! -f "$scratch/web/playground/index.html" ]; then
        leave_out playground "npm cannot get its libraries"
        return
    fi
    cp -R "$scratch/web/playground" "$scratch/$name"
    chmod 644 "$scratch/$name"/*.wasm
    archive "$name"
    library playground wasi-libc "$(version_line wasi-libc | sed 's/.* //')"
    cp "$scratch/$name/LICENSES.txt" "$scratch/playground_licenses"
}

make_csharp()
{
    local to=$scratch/scarp-csharp-$version from=$source/src/bindings/csharp
    mkdir "$to"
    cp "$source/LICENSE" "$from/README.md" "$from/Scarp.cs" "$to"
    cp -R "$from/unity" "$to"
    archive "${to##*/}"
}

make_shaders()
{
    local to=$scratch/scarp-shaders-$version
    mkdir "$to"
    cp "$source/LICENSE" "$source"/include/scarp.{glsl,hlsl,wgsl} "$source/src/gpu/README.md" "$to"
    archive "${to##*/}"
}

log=$scratch/log
explain()
{
    if [ $? != 0 ] && [ -s "$log" ]; then
        echo "pack.sh: ${part:-nothing} cannot be made; the end of what was said:" >&3
        tail -n 30 "$log" >&3
    fi
}
trap explain EXIT
for part in ${parts//,/ }; do
    [ "$part" != source ] || continue # release.sh makes it
    begun=$SECONDS missing=
    : >"$log"
    for tool in ${needs[$part]}; do
        has "$tool" || missing+=" $tool"
    done
    if [ "$missing" ]; then
        leave_out "$part" "there is no$missing"
        continue
    fi
    for tool in ${needs[$part]} tar gzip; do
        printf '%s\t%s\t%s\n' "$part" "$tool" "$(version_line "$tool")" >>"$scratch/tools"
    done
    "make_$part" >"$log" 2>&1
    echo "    $part: $((SECONDS - begun)) s"
done
