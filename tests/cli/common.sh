# SPDX-License-Identifier: MIT
# What the shell tests of the program share. They need nothing but a POSIX shell and what every
# system has, so the essentials are tested where there is no Python.
#
#     sh NAME.sh PROGRAM [EMULATOR...]
#
# Each begins in an empty directory of its own.
# shellcheck shell=sh disable=SC2034,SC2154

set -eu
source_dir=$(cd ../.. && pwd)
program=$1
shift
emulator=$*
scratch=$(mktemp -d)
notes=$scratch/notes
mkdir "$notes" "$scratch/files"
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
cd "$scratch/files"

fail()
{
    echo "FAILED: $*"
    exit 1
}

scarp()
{
    # shellcheck disable=SC2086 # words
    $emulator "$program" "$@"
}

# Runs `scarp terrain`, which must succeed in silence.
quietly()
{
    scarp terrain "$@" --quiet >"$notes/output" 2>&1 || fail "$* ends with $?: $(cat "$notes/output")"
    [ ! -s "$notes/output" ] || fail "$* prints $(cat "$notes/output")"
}

# same FILE FILE: they have the same bytes
same()
{
    cmp "$1" "$2" || fail "$1 differs from $2"
}

# one_line WORD FILE: the file is one line of an error that has the word
one_line()
{
    if [ "$(wc -l <"$2")" -ne 1 ] || ! grep -q '^scarp: ' "$2" || ! grep -qF -e "$1" "$2"; then
        fail "this is not one line about $1: $(cat "$2")"
    fi
}

# refused STATUS WORD ARGUMENT...: the program ends with the status and one line that has the word,
# and writes nothing else
refused()
{
    expected=$1 word=$2 status=0
    shift 2
    ls -A >"$notes/before"
    scarp "$@" >"$notes/output" 2>"$notes/error" || status=$?
    [ $status = "$expected" ] || fail "$* ends with $status"
    one_line "$word" "$notes/error"
    [ ! -s "$notes/output" ] || fail "$* prints $(cat "$notes/output")"
    ls -A >"$notes/after"
    cmp "$notes/before" "$notes/after" || fail "$* leaves files: $(cat "$notes/after")"
}

# bytes FILE OFFSET COUNT: that many bytes of the file
bytes()
{
    tail -c +$(($2 + 1)) "$1" | head -c "$3"
}
