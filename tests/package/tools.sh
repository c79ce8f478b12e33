#!/bin/sh
# SPDX-License-Identifier: MIT
# Without any tool the suite has the same tests. Those that need one are skipped by name, and fail
# where SCARP_REQUIRE_TOOLS names it.
. ./common.sh
fresh tools

# What find_program and find_package find, they do not look for where they are told that it is OFF.
set -- -DSCARP_TEST_THOROUGH="$thorough" -DCMAKE_NM=OFF -DCMAKE_OBJDUMP=OFF -DSCARP_CXX=OFF -DSCARP_BUILD_CLI=OFF \
    -DSCARP_BUILD_BENCH=OFF -DSCARP_INSTALL=OFF
for tool in ABIDIFF BASH GROFF PKG_CONFIG SH VALGRIND; do
    set -- "$@" "-DSCARP_$tool=OFF"
done
for package in Python3 Threads; do
    set -- "$@" "-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"
done
configure "$source_dir" "$dir/build" "$@" >"$dir/log" 2>&1 || fail "$(cat "$dir/log")"
grep 'will be skipped' "$dir/log" || fail "what is missing is not named: $(cat "$dir/log")"
"$cmake" --build "$dir/build" --config "$config" --target test_skip >"$dir/log" 2>&1 ||
    fail "$(cat "$dir/log")"

# From a directory of their own, for ctest empties the log of the directory that it is asked about.
names() # BUILD_DIR
{
    mkdir -p "$dir/list"
    echo "subdirs(\"$1\")" >"$dir/list/CTestTestfile.cmake"
    "$ctest" --test-dir "$dir/list" -C "$config" -N | sed -n 's/^ *Test *#[0-9]*: //p' | sort
}
names "$build_dir" >"$dir/with"
names "$dir/build" >"$dir/without"
[ "$(wc -l <"$dir/with")" -gt 50 ] || fail "ctest lists hardly any test"
diff "$dir/with" "$dir/without" || fail "tests are not there without tools (<), or only then (>)"

# expect STATUS LINE TEST: ctest says that about the test, which prints the line
expect()
{
    "$ctest" --test-dir "$dir/build" -C "$config" -V -FA . -R "^$3\$" >"$dir/log" 2>&1 || true
    if ! grep -q "$3 .*\*\*\*$1" "$dir/log" || ! grep -q "^[0-9]*: $2\$" "$dir/log"; then
        fail "$3 is not $1 with the line '$2': $(cat "$dir/log")"
    fi
}
unset SCARP_REQUIRE_TOOLS
for pair in abidiff:package.abi bash:cli.completion c++:package.header.cxx groff:cli.roff nm:package.symbols \
    objdump:package.audit pkg-config:package.pkg_config pthreads:threads python3:readme.c \
    scarp:cli.formats scarp-bench:bench.selection scarp-install:package.install sh:package.duration \
    ${thorough:+valgrind:cost}; do
    tool=${pair%:*} test=${pair#*:}
    expect Skipped "skipped: $tool is missing" "$test"
    SCARP_REQUIRE_TOOLS=cmake expect Failed "cmake is no tool of any test" "$test"
    SCARP_REQUIRE_TOOLS=posix,$tool expect Failed "FAILED (required): $tool is missing" "$test"
done
"$ctest" --test-dir "$dir/build" -C "$config" -R '^readme[.]c$' >"$dir/log" 2>&1 || true
grep '^Skipped for want of tools (how many tests): python3 1$' "$dir/log" || fail "skipped for nothing: $(cat "$dir/log")"
grep '^Most of them run after: apt-get install python3$' "$dir/log" || fail "no package is named: $(cat "$dir/log")"
