#!/bin/sh
# SPDX-License-Identifier: MIT
# Types what README.md shows under "The first program" and "Linking", in this order, in a tree of scarp.
# hello.c must print what is shown there, each of three times.
#
#     readme_lines.sh README TREE PROJECT    PROJECT is an empty folder, for the project of CMake
set -eu
readme=$1 tree=$2 project=$3

# block SECTION LANGUAGE NUMBER: the block of that number and language in a section
block()
{
    awk -v section="## $1" -v language="\`\`\`$2" -v number="$3" '
        /^## / { here = $0 == section }
        inside && /^```$/ { inside = 0; next }
        inside { if (wanted) print; next }
        here && /^```/ { inside = 1; wanted = $0 == language && ++count == number }
        ' "$readme"
}

# Types lines in a folder; what the last program prints is that of the README.
typed() # FOLDER LINES
{
    echo "$2"
    (cd "$1" && sh -ec "$2") >"$tree/typed.log" 2>&1 || {
        cat "$tree/typed.log"
        exit 1
    }
    tail -n 3 "$tree/typed.log" >"$tree/printed"
    diff "$tree/printed" "$tree/wanted"
}

block "The first program" c 1 >"$tree/hello.c"
block "The first program" "" 1 >"$tree/wanted"
grep -q scarp_sample2 "$tree/hello.c"
[ "$(grep -c . "$tree/wanted")" = 3 ]
cp "$tree/hello.c" "$project"
block Linking cmake 1 >"$project/CMakeLists.txt"
grep -q find_package "$project/CMakeLists.txt"

typed "$tree" "$(block "The first program" sh 1)"
rm "$tree/hello"
typed "$tree" "$(block Linking sh 1)
$(block Linking sh 2)"
export LD_LIBRARY_PATH= # CMake gives programs of its build a path
typed "$project" "$(block Linking sh 3)"
