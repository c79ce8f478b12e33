#!/bin/sh
# SPDX-License-Identifier: MIT
# The consumer with scarp as a subdirectory, its own or FetchContent's: only the library is built,
# always optimised, and nothing of it is installed unless SCARP_INSTALL asks for it. The consumer in
# C++, which has no C of its own, takes over the library that the consumer in C compiled.
. ./common.sh

# find_worst BUILD: sets $worst to the least optimised kernel's last -O flag; - is none. Fails if the
# generator does not print its commands.
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
    -DCMAKE_C_FLAGS="$c_flags -O1 -pedantic" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DCMAKE_UNITY_BUILD=ON -DSCARP_WERROR=ON -DSCARP_INSTALL=OFF -DCONSUMER_EXPORT=OFF
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
[ "$language" = C ] || exit 0

static=$(find "$dir/_deps/scarp-build" -name 'libscarp.a')
if [ "$system" = Linux ] && [ -n "$static" ] && [ -n "$nm" ]; then
    compile -shared -nostdlib -Wl,--whole-archive "$static" -Wl,--no-whole-archive -o "$dir/plugin.so"
    if "$nm" -D --defined-only "$dir/plugin.so" | grep -E 'scarpi?_'; then
        fail "the static library exports its calls from a plugin"
    fi
fi

echo "a project that exports a library of its own, which uses scarp"
configure_consumer . "$dir" -DSCARP_INSTALL=ON -DCONSUMER_EXPORT=ON >"$log" 2>&1 ||
    fail "cannot be configured with an export set: $(cat "$log")"
build "$dir" >"$log" 2>&1 || fail "does not build: $(cat "$log")"
"$cmake" --install "$dir" --config "$config" --prefix "$dir/exported" >"$log"
[ ! -e "$dir/exported/share" ] || fail "installed into the prefix of a C project: $(cat "$log")"
mkdir "$dir/user"
cat >"$dir/user/CMakeLists.txt" <<'EOF'
cmake_minimum_required(VERSION 3.25)
project(user C)
find_package(scarp REQUIRED)
include(${CMAKE_PREFIX_PATH}/lib/cmake/noise/noiseTargets.cmake)
add_executable(user user.c)
target_link_libraries(user PRIVATE noise::noise)
set_target_properties(user PROPERTIES RUNTIME_OUTPUT_DIRECTORY $<1:${CMAKE_BINARY_DIR}>)
EOF
echo 'const char *noise_version(void);
int main(void) { return noise_version()[0] == 0; }' >"$dir/user/user.c"
configure "$dir/user" "$dir/user/build" -DCMAKE_PREFIX_PATH="$dir/exported"
build "$dir/user/build"
run "$dir/user/build/user"
