#!/bin/sh
# SPDX-License-Identifier: MIT
# scarp.hpp: the programs of tests/cpp run, and compile without a warning, also by the other
# compilers of this machine; the header does without exceptions.
. ./common.sh

case $c_compiler_id in
GNU | *Clang) ;;
*) skip "no flags known for $c_compiler_id" ;;
esac

# strict COMPILER ARGUMENT...
strict()
{
    "$@" -std=c++20 -I"$source_dir/include" -Wall -Wextra -Wpedantic -Wconversion -Wshadow \
        -Wold-style-cast -Werror
}

has_spans() # COMPILER
{
    echo '#include <span>
std::span<int> s;' | "$1" -std=c++20 -x c++ -fsyntax-only - 2>/dev/null
}
has_spans "$cxx_compiler" || skip "$cxx_compiler has no spans"

fresh cpp
echo '#include <scarp.hpp>' >"$dir/alone.cpp"
strict "$cxx_compiler" -fno-exceptions -fno-rtti -fsyntax-only "$dir/alone.cpp"
for test in calls recipes; do
    # shellcheck disable=SC2086 # words
    strict "$cxx_compiler" -pthread $c_flags "../cpp/test_$test.cpp" "$library" $link_flags \
        "-Wl,-rpath,$(dirname "$library")" -lm -o "$dir/$test"
    run "$dir/$test" || fail "$test"
    if [ -n "$nm" ] && "$nm" "$dir/$test" | grep -E '[^0-9]5scarp' | grep -v '5scarp[0-9]*v[0-9]'; then
        fail "functions of scarp.hpp without its version"
    fi
    for other in g++ clang++ clang++-19; do
        [ "$other" != "$(basename "$cxx_compiler")" ] || continue
        if [ "$cross" = 0 ] && has_spans "$other"; then
            echo "$test by $other"
            strict "$other" -fsyntax-only "../cpp/test_$test.cpp"
        fi
    done
done
