#!/bin/sh
# SPDX-License-Identifier: MIT
# Command lines that are refused with one line and status 2, having done nothing; and files that
# cannot be written, which end the program with one line and status 1, and are not left half.
. ./common.sh

refused 2 bogus bogus
refused 2 --bogus terrain --bogus
refused 2 stray terrain stray
for pair in size=0x64 size=64 step=0 height=-1 octaves=33 octaves=nan frequency=0 lacunarity=17 \
    gain=x seed=--1 basis=none fractal=fBm fade=linear threads=0 isa=sse9 origin=1 tile=0x1 \
    azimuth=361 preset=everest overlap=-1; do
    refused 2 "--${pair%=*}" terrain --size 40x30 --heights t.r32 "--${pair%=*}" "${pair#*=}"
    refused 2 "--${pair%=*}" terrain --size 40x30 --heights t.r32 "--$pair"
done
refused 2 --seed terrain --seed
refused 2 --heights terrain --size 40x30 --heights t.bogus
refused 2 --heights terrain --size 40x30 --heights missing/t.r32
refused 2 --normals terrain --size 40x30 --heights t.r32 --normals n.r16
refused 2 --heights terrain --size 40x30 --heights t.r32 --heights
refused 2 --gain sample --gain 99

# Nothing of what fits on the disk is left either, and what was there before stays.
if [ -c /dev/full ]; then
    refused 1 /dev/full terrain --size 40x30 --heights r32:/dev/full --normals n.ppm
    status=0
    scarp --help >/dev/full 2>"$notes/error" || status=$?
    [ $status = 1 ] || fail "help on a full disk ends with $status"
    one_line 'standard output' "$notes/error"
fi
echo old >h.r32
limited()
{
    (
        ulimit -f 64
        scarp terrain --size 300x300 --quiet --heights h.r32 --normals n.ppm 2>"$notes/error"
    )
}
status=0
limited || status=$?
[ $status = 1 ] || fail "a limit on the size of files ends the program with $status"
one_line --heights "$notes/error"
[ "$(ls -A)" = h.r32 ] || fail "files are left: $(ls -A)"
[ "$(cat h.r32)" = old ] || fail "an older file was changed"

# Whoever reads goes away.
{
    status=0
    scarp terrain --size 600x600 --quiet --heights r32:- --hillshade s.pgm 2>"$notes/error" ||
        status=$?
    echo $status >"$notes/status"
} | head -c 100 >"$notes/output"
[ "$(cat "$notes/status")" = 1 ] || fail "a closed pipe ends the program with $(cat "$notes/status")"
one_line --heights "$notes/error"
[ "$(ls -A)" = h.r32 ] || fail "files are left: $(ls -A)"
