# SPDX-License-Identifier: MIT
# What the package tests share. They run in this directory. Arguments: a file of settings that
# ../package.cmake writes (compiler, flags, directories, tools), and the consumer's language, C or
# CXX.
# shellcheck shell=sh disable=SC2034,SC2154

set -eu
. "$1"
unset DESTDIR PKG_CONFIG_PATH PKG_CONFIG_SYSROOT_DIR

language=${2:-C}
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
    [ ! -d "$dir" ] || chmod -R u+w "$dir" # copies of sources that nobody may write
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
        -DCMAKE_SHARED_LINKER_FLAGS="$link_flags" -DSCARP_SETS="$sets" "$@"
}

# configure_consumer SOURCE BUILD OPTION...: a project only in $language, C or CXX
configure_consumer()
{
    if [ "$language" = CXX ]; then
        set -- "$@" -DCMAKE_CXX_COMPILER="$cxx_compiler" -DCMAKE_CXX_FLAGS="$c_flags"
    fi
    configure "$@" -DCONSUMER_LANGUAGE="$language"
}

build()
{
    "$cmake" --build "$1" --config "$config"
}

# Compiles as the project does, sanitizers and all, in $language.
compile()
{
    compiler=$c_compiler
    [ "$language" = C ] || compiler=$cxx_compiler
    echo "+ $compiler $c_flags $*"
    # shellcheck disable=SC2086 # words
    "$compiler" $c_flags "$@" $link_flags
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
