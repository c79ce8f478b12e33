#!/bin/sh
# SPDX-License-Identifier: MIT
# A run that is told to stop ends by the signal with one line, and leaves no unfinished file.
. ./common.sh
process=
trap '[ -z "$process" ] || kill -s KILL "$process" 2>"$notes/output"; rm -rf "$scratch"' EXIT

# Minutes of work, in bands that take a fraction of a second
set -- --size 3000x100000 --octaves 32 --frequency 0.01 --lacunarity 1.1 --threads 1 --quiet

# wait_for WHAT: until such a file is there; gives up after a minute
wait_for()
{
    patience=600
    until [ -n "$(find . -name "$1")" ]; do
        patience=$((patience - 1))
        [ $patience -gt 0 ] || fail "there is no $1: $(cat "$notes/error")"
        sleep 0.1
    done
}

# Sends the signal to $process, which ends by it.
interrupt()
{
    kill -s "$1" "$process" || fail "the run ended by itself: $(cat "$notes/error")"
    status=0
    wait "$process" || status=$?
    [ "$(kill -l $status)" = "$1" ] || fail "$1: the run ends with $status"
    process=
    one_line interrupted "$notes/error"
}

echo old >h.r32
for signal in TERM HUP; do
    # shellcheck disable=SC2086 # words; no function here, whose process would be a shell
    $emulator "$program" terrain "$@" --heights h.r32 --normals n.npy 2>"$notes/error" &
    process=$!
    wait_for '*.part'
    interrupt $signal
    [ "$(ls -A)" = h.r32 ] || fail "$signal: files are left: $(ls -A)"
    [ "$(cat h.r32)" = old ] || fail "$signal: an older file was changed"
done

# Finished tiles stay, and they are whole.
# shellcheck disable=SC2086 # words
$emulator "$program" terrain "$@" --tile 3000x50 --heights t.r32 2>"$notes/error" &
process=$!
wait_for 't_2_0.r32'
interrupt TERM
for file in *; do
    case $file in
    t_*_0.r32) [ "$(wc -c <"$file")" -eq 600000 ] || fail "$file is not whole" ;;
    *.part) fail "files are left: $(ls -A)" ;;
    esac
done
