#!/bin/bash
# SPDX-License-Identifier: MIT
# Uses what ../release.sh made, each artifact as its users do, on this machine and without a network:
#
#   cmake/release/try.sh FOLDER
#
# All that computes has to give the same noise at a point. What is not in FOLDER, or needs a tool that is
# missing, is told and not tried. Nothing is installed into the system.
# shellcheck disable=SC2317 # try calls them
set -eu -o pipefail
folder=$(cd "$1" && pwd -P)
tests=$(cd "$(dirname "$0")/../../tests/package" && pwd -P)
work=$(mktemp -d "${TMPDIR:-/tmp}/scarp-try.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
unset CFLAGS LDFLAGS PYTHONPATH CARGO_TARGET_DIR SCARP_LIBRARY SCARP_LIB_DIR
cd "$work"
cc=${CC:-cc}
failed=0
expected=0.175932094 # of the noise below, to 9 digits: the bits of a float

fail() # TEXT
{
    echo "FAILED: $*"
    exit 1
}

# try NAME PATTERN TOOL...: lets try_NAME use the artifacts, in a folder of its own
try()
{
    local name=$1 pattern=$2 tool
    shift 2
    if [ -z "$(compgen -G "$folder/$pattern")" ]; then
        echo "$name: not here"
        return
    fi
    for tool; do
        if ! command -v "$tool" >/dev/null; then
            echo "$name: not tried, since there is no $tool"
            return
        fi
    done
    mkdir "$work/$name"
    # A condition would let it go on after a mistake.
    set +e
    (set -e; cd "$work/$name"; "try_$name") >"$work/$name.log" 2>&1
    status=$?
    set -e
    if [ $status != 0 ]; then
        failed=1
        echo "$name: FAILED"
        tail -n 20 "$work/$name.log" | sed 's/^/    /'
    else
        echo "$name: works"
    fi
}

# The program gives the noise, and draws a terrain.
program() # COMMAND...
{
    local found
    found=$(printf 'x,y\n12.5,7.75\n' | "$@" sample --seed 42 --octaves 6 --frequency 0.01 | tail -n 1)
    [ "$found" = "$expected" ] || fail "the program says $found"
    "$@" terrain --preset alps --size 64x48 --heights heights.r32 --relief relief.png
    [ "$(wc -c <heights.r32)" = $((64 * 48 * 4)) ]
    file relief.png | grep 'PNG image data, 64 x 48'
}

python_with_numpy()
{
    local python
    for python in python3 /usr/bin/python3; do
        if "$python" -c 'import numpy' 2>/dev/null; then
            echo "$python"
            return
        fi
    done
    fail "there is no Python with NumPy"
}

module() # PLACE: the module for Python there
{
    PYTHONPATH=$1 "$(python_with_numpy)" -B - "$1" "$expected" <<'END'
import sys
import scarp
assert scarp.__file__.startswith(sys.argv[1]), scarp.__file__
found = "%.9g" % scarp.Noise(seed=42, octaves=6, frequency=0.01).at(12.5, 7.75).value
assert found == sys.argv[2], found
print(scarp.preset("alps").grid((4, 5)).value.shape, scarp.__file__)
END
}

try_sums()
{
    cd "$folder"
    sha256sum -c SHA256SUMS
    [ "$(find . -type f | wc -l)" = $(($(wc -l <SHA256SUMS) + 1)) ] || fail "there are files without a sum"
}

try_archive()
{
    tar -xzf "$folder"/scarp-*-linux-*.tar.gz --strip-components=1
    program bin/scarp
    cmake -S "$tests" -B build -DCMAKE_PREFIX_PATH="$PWD"
    cmake --build build
    build/consumer
}

try_deb()
{
    local package found
    for package in "$folder"/*.deb; do
        dpkg-deb -x "$package" .
    done
    found=$(find usr -type d ! -perm 755)
    [ -z "$found" ] || fail "folders that not everybody may read: $found"
    LD_LIBRARY_PATH=$(dirname "$PWD"/usr/lib/*/libscarp.so.*.*.*)
    export LD_LIBRARY_PATH
    program usr/bin/scarp
    module "$PWD/usr/lib/python3/dist-packages"
}

try_single()
{
    tar -xzf "$folder"/scarp-*-single.tar.gz --strip-components=1
    "$cc" -std=c11 -O1 -ffp-contract=off -DSCARP_AVX512=0 -DSCARP_AVX2=0 -I. scarp_single.c "$tests/consumer.c" -lm -o consumer
    ./consumer
}

try_wheel()
{
    python3 -m pip install --quiet --no-index --no-deps --disable-pip-version-check --root-user-action=ignore \
        --target here "$folder"/scarp-*.whl
    module "$PWD/here"
}

try_crate()
{
    tar -xzf "$folder"/scarp-*.crate --strip-components=1
    export SCARP_BUILD=source CFLAGS='-O1 -DSCARP_AVX512=0 -DSCARP_AVX2=0'
    cargo run --offline --example hillshade -- 60 40 3
    [ "$(wc -c <hillshade.pgm)" = 2413 ] || fail "no picture"
}

try_npm()
{
    echo '{"private": true}' >package.json
    npm install --offline --ignore-scripts --no-audit --no-fund --loglevel=error --cache npm "$folder"/scarp-noise-*.tgz
    cat >use.mjs <<'END'
import { load } from 'scarp-noise';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
for (const name of ['scarp-simd.wasm', 'scarp-fallback.wasm']) {
    const module = readFileSync(fileURLToPath(import.meta.resolve(`scarp-noise/${name}`)));
    if (!WebAssembly.validate(module)) {
        throw new Error(`${name} is no module`);
    }
}
const scarp = await load(), value = new Float32Array(1);
scarp.sample2({ seed: 42, octaves: 6, frequency: 0.01 }, Float32Array.of(12.5), Float32Array.of(7.75), { value });
console.log(value[0].toPrecision(9));
END
    [ "$(node use.mjs)" = "$expected" ] || fail "node says $(node use.mjs)"
}

# The page asks for nothing that is not there, and its modules are modules.
try_playground()
{
    tar -xzf "$folder"/scarp-playground-*.tar.gz --strip-components=1
    grep -oE '(src|href)="[^":#?]+"' index.html | sed 's/.*="//; s/"$//' | while read -r name; do
        [ -e "$name" ] || fail "the page lacks $name"
    done
    node -e 'for (const name of ["page-simd.wasm", "page-fallback.wasm"])
        new WebAssembly.Module(require("fs").readFileSync(name));'
}

try_csharp()
{
    tar -xzf "$folder"/scarp-csharp-*.tar.gz --strip-components=1
    mcs -unsafe -langversion:latest -target:library -out:scarp.dll Scarp.cs
}

try_shaders()
{
    tar -xzf "$folder"/scarp-shaders-*.tar.gz --strip-components=1
    ls LICENSE README.md scarp.glsl scarp.hlsl scarp.wgsl
}

try sums SHA256SUMS sha256sum
try archive 'scarp-*-linux-*.tar.gz' cmake file "$cc"
try deb '*.deb' dpkg-deb file
try single 'scarp-*-single.tar.gz' "$cc"
try wheel '*.whl' python3
try crate '*.crate' cargo "$cc"
try npm 'scarp-noise-*.tgz' node npm
try playground 'scarp-playground-*.tar.gz' node
try csharp 'scarp-csharp-*.tar.gz' mcs
try shaders 'scarp-shaders-*.tar.gz' tar
exit $failed
