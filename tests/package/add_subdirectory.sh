#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer with scarp as a subdirectory, its own or FetchContent's: only the library is built,
# always optimised, and nothing of it is installed. The consumer in C++, which has no C of its own,
# takes over the library that the consumer in C compiled.
. ./common.sh

# find_worst BUILD: sets $worst to the least optimised kernel's last -O flag; - is none. Fails if the
# generator does not tell its commands.
find_worst()
{
    [ -e "$1/compile_commands.json" ] || return 1
    worst=$(awk '/"command":/ && /(kernels_[a-z0-9]*|scalar.points)\.c"/ {
            level = "-"
            for (i = 1; i <= NF; i++)
                if ($i ~ /^[\/-](clang:-)?O/)
                    level = $i
            print level
        }' "$1/compile_commands.json" | sort | sed -n '1p')
}

fresh "add_subdirectory-$language"
log=$dir/log
for fetch in OFF ON; do
    for type in "" Debug; do
        configure_consumer . "$dir/build" -DSCARP_SOURCE="$source_dir" -DSCARP_FETCH=$fetch \
            -DCMAKE_BUILD_TYPE="$type" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$log" 2>&1 ||
            fail "cannot be configured: $(cat "$log")"
        if find_worst "$dir/build"; then
            echo "FetchContent $fetch, build type '$type': the library is compiled with $worst"
            case $worst in
            *O[23]) ;;
            *) fail "kernels are not optimised" ;;
            esac
        fi
    done
done

# -O1 compiles fastest, twice as fast as -O3, and is told from the library's own flags.
dir=$scratch/subproject
[ "$language" != C ] || rm -rf "$dir"
configure_consumer . "$dir" -DSCARP_SOURCE="$source_dir" -DCMAKE_BUILD_TYPE= -DSCARP_OPTIMIZE=OFF \
    -DCMAKE_C_FLAGS="$c_flags -O1" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
if find_worst "$dir"; then
    [ "$worst" = -O1 ] || fail "SCARP_OPTIMIZE=OFF does not leave the flags as they are: $worst"
fi
build "$dir" >"$log" 2>&1 || fail "does not build: $(cat "$log")"
run "$dir/consumer"

"$cmake" --install "$dir" --config "$config" --prefix "$dir/prefix"
[ ! -e "$dir/prefix" ] || fail "installing the consumer installed scarp"
if "$cmake" --build "$dir" --config "$config" --target scarp_internal >/dev/null 2>&1; then
    fail "the tests are a part of the consumer's build"
fi
