# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# What has to be so before a release, for ../release.sh: each function refuses, says what is lacking, which a
# rehearsal lets pass, or says nothing. They set `version` and `commit`, and `keep` if files are worth a look.

check_commit()
{
    local top changed
    top=$(git -C "$root" rev-parse --show-toplevel 2>/dev/null) || refuse "$root is no checkout of git"
    [ "$(cd "$top" && pwd -P)" = "$root" ] || refuse "$root is no checkout of git, but lies in one"
    changed=$(git -C "$root" status --porcelain | head -n 1)
    [ -z "$changed" ] || refuse "the tree is not what is committed: $changed"
    commit=$(git -C "$root" rev-parse HEAD)
}

# The version of include/scarp.h, and every other place that has it, with the command by which sed finds it
places='
src/bindings/interface.json             s/^ *"version": "(.*)",$/\1/p
src/bindings/python/scarp/_interface.py s/^VERSION = .(.*).$/\1/p
src/bindings/rust/Cargo.toml            s/^version = "([^"]*)".*/\1/p
src/bindings/rust/Cargo.lock            /^name = "scarp"$/{n;s/^version = "(.*)"$/\1/p}
src/bindings/rust/src/ffi.rs            s/^pub const VERSION: &str = "(.*)";$/\1/p
src/web/package.json.in                 s/^ *"version": "(.*)",$/\1/p
cmake/packaging/vcpkg/vcpkg.json        s/^ *"version": "(.*)",$/\1/p
CHANGELOG.md                            s/^## ([0-9.]+) .*/\1/p
'

check_version()
{
    local file command found
    version=$(sed -nE 's/^#define SCARP_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' "$root/include/scarp.h" |
        paste -sd .)
    [[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || refuse "include/scarp.h has no version"
    while read -r file command; do
        [ "$file" ] || continue
        found=$(sed -nE "$command" "$root/$file" | head -n 1)
        [ "$found" = "$version" ] || [ "$found" = @PROJECT_VERSION@ ] ||
            refuse "$file has the version ${found:-(none)}, include/scarp.h has $version"
    done <<<"$places"
}

check_changelog()
{
    local heading date
    heading=$(grep -m 1 '^## ' "$root/CHANGELOG.md")
    date=$(sed -nE 's/^## [0-9.]+ \(([0-9]{4}-[0-9]{2}-[0-9]{2})\)$/\1/p' <<<"$heading")
    [ "$date" ] || lacks "CHANGELOG.md has no date (YYYY-MM-DD) for $version: $heading"
}

check_tag()
{
    local tag=v$version
    if ! git -C "$root" rev-parse -q --verify "refs/tags/$tag" >/dev/null; then
        lacks "there is no tag $tag"
    elif [ "$(git -C "$root" cat-file -t "$tag")" != tag ]; then
        refuse "$tag is not annotated"
    elif [ "$(git -C "$root" rev-parse "$tag^{commit}")" != "$commit" ]; then
        refuse "$tag is another commit than the one that is checked out"
    fi
}

missing_tool() # TOOL TEXT
{
    [ -z "$require_all" ] || refuse "$1 is missing: $2"
    echo "$1 is missing: $2"
}

# All golden lines are frozen, and are those that tests/test_golden.c knows. Comparing calls nothing of the
# library, which is not there to link with.
check_golden()
{
    local added program=$work/test_golden cc=${CC:-cc}
    added=$(grep -cE '^[^ ]+ [^ ]+ [^ ]' "$root/tests/golden.txt") || true
    [ "$added" = 0 ] || lacks "tests/golden.txt has lines that are not frozen: $added"
    if ! $cc -std=c11 -O0 -I"$root/include" "$root/tests/test_golden.c" -o "$program" \
        -no-pie -Wl,--unresolved-symbols=ignore-all -lm >"$work/log" 2>&1; then
        missing_tool "a linker that lets pass what is undefined" "the golden lines are not compared"
    elif ! "$program" --frozen "$root/tests/golden.txt" >"$work/log"; then
        refuse "tests/golden.txt is not as it was frozen: $(grep -m 1 released "$work/log" || head -n 1 "$work/log")"
    fi
}

# tests/package/abi.xml is renewed. That it keeps what was promised, a test says.
check_interface()
{
    local status=0 cc=${CC:-cc} tool
    for tool in abidiff abidw "$cc"; do
        if ! command -v "$tool" >/dev/null; then
            missing_tool "$tool" "the binary interface is not compared"
            return
        fi
    done
    cat >"$work/settings" <<END
abidiff=abidiff
abidw=abidw
processor='$(uname -m)'
system='$(uname -s)'
c_compiler='$cc'
c_compiler_id='$("$cc" --version | grep -q 'Free Software' && echo GNU)'
c_flags=''
version='$version'
source_dir='$root'
scratch='$work/abi'
END
    (cd "$root/tests/package" && sh abi.sh "$work/settings" same) >"$work/log" 2>&1 || status=$?
    case $status in
    0) ;;
    77) missing_tool "gcc on x86-64" "the binary interface is not compared: $(tail -n 1 "$work/log")" ;;
    *) lacks "tests/package/abi.xml is not what the sources say; renew it: $(grep -m 1 -E '^ *\[|FAILED' "$work/log")" ;;
    esac
}

# Fuzz targets, built from the commit, find nothing in $fuzz seconds. They run on $jobs processors.
try_fuzz()
{
    local tool targets each sources=$work/fuzz/source build=$work/fuzz/build
    [ "$fuzz" -gt 0 ] || return 0
    for tool in clang-19 cmake ctest; do
        if ! command -v $tool >/dev/null; then
            missing_tool $tool "the fuzz targets are not run"
            return
        fi
    done
    mkdir -p "$sources"
    git -C "$root" archive "$commit" | tar -x -C "$sources"
    if ! cmake -S "$sources" -B "$build" -DCMAKE_BUILD_TYPE=Release -DSCARP_BUILD_FUZZERS=ON \
        -DCMAKE_C_COMPILER=clang-19 >"$work/log" 2>&1 || ! cmake --build "$build" -j "$jobs" >>"$work/log" 2>&1; then
        refuse "the fuzz targets cannot be built: $(grep -m 1 -i error "$work/log" || tail -n 1 "$work/log")"
    fi
    targets=$(ctest --test-dir "$build" -L fuzz -N | sed -n 's/^Total Tests: //p')
    each=$(((fuzz * jobs + targets - 1) / targets))
    echo "$targets fuzz targets, $fuzz seconds"
    if ! SCARP_FUZZ_SECONDS=$each ctest --test-dir "$build" -L fuzz -j "$jobs" --no-tests=error \
        --output-on-failure >"$work/log" 2>&1; then
        keep=yes
        refuse "a fuzz target found something: see $work/log, and $build/tests/fuzz/found"
    fi
    rm -rf "$work/fuzz"
}
