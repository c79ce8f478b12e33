# SPDX-License-Identifier: MIT
# What the package tests share. They run in this directory, with one argument: a file of settings
# that ../package.cmake writes (compiler, flags, directories, tools).
# shellcheck shell=sh disable=SC2034,SC2154

set -eu
. "$1"
unset DESTDIR PKG_CONFIG_PATH PKG_CONFIG_SYSROOT_DIR

prefix=$scratch/elsewhere/prefix # where install.sh leaves what it installed

skip()
{
    echo "skipped: $*"
    exit 77
}

fail()
{
    echo "FAILED: $*"
    exit 1
}

# An empty directory of this name, in $dir.
fresh()
{
    dir=$scratch/$1
    rm -rf "$dir"
    mkdir -p "$dir"
}

# configure SOURCE BUILD OPTION...: as the project itself was configured
configure()
{
    from=$1 to=$2
    shift 2
    [ -z "$toolchain" ] || set -- "$@" -DCMAKE_TOOLCHAIN_FILE="$toolchain"
    "$cmake" -S "$from" -B "$to" -G "$generator" -DCMAKE_MAKE_PROGRAM="$make_program" \
        -DCMAKE_BUILD_TYPE="$config" -DCMAKE_C_COMPILER="$c_compiler" \
        -DCMAKE_C_FLAGS="$c_flags" -DCMAKE_EXE_LINKER_FLAGS="$link_flags" \
        -DCMAKE_SHARED_LINKER_FLAGS="$link_flags" "$@"
}

build()
{
    "$cmake" --build "$1" --config "$config"
}

# Compiles as the project does, sanitizers and all.
compile()
{
    echo "+ $c_compiler $c_flags $*"
    # shellcheck disable=SC2086 # words
    "$c_compiler" $c_flags "$@" $link_flags
}

# Runs a program that was built here.
run()
{
    # shellcheck disable=SC2086 # words
    $emulator "$@"
}

sanitized()
{
    case $c_flags in
    *-fsanitize*) true ;;
    *) false ;;
    esac
}

# Whether the C compiler's driver also compiles C++: gcc does if g++ is installed.
compiles_cxx()
{
    echo 'int main() { return 0; }' | "$c_compiler" -x c++ -fsyntax-only - 2>/dev/null
}
