#!/bin/sh
# SPDX-License-Identifier: MIT
# What is in the files of each format: headers, sizes, and the same samples in all of them.
. ./common.sh
set -- --size 40x30 --frequency 0.03 --octaves 3

# sized FILE BYTES HEADER: the file has that size and begins with the text, as printf has it
sized()
{
    [ "$(wc -c <"$1")" -eq "$2" ] || fail "$1 has $(wc -c <"$1") bytes instead of $2"
    # shellcheck disable=SC2059 # a format
    printf "$3" >"$notes/header"
    head -c "$(wc -c <"$notes/header")" "$1" | cmp - "$notes/header" || fail "the header of $1"
}

# The rows of h.r32, 160 bytes each, from the bottom up
from_below()
{
    row=30
    while [ $row -gt 0 ]; do
        row=$((row - 1))
        bytes h.r32 $((160 * row)) 160
    done
}

for name in h.r16 h.r32 h.pgm h.pfm h.img h.npy; do
    quietly "$@" --heights $name
done
sized h.r16 2400 ''
sized h.r32 4800 ''
sized h.pgm $((15 + 2400)) 'P5\n40 30\n65535\n'
sized h.pfm $((14 + 4800)) 'Pf\n40 30\n-1.0\n'
sized h.npy $((128 + 4800)) "\\223NUMPY\\001\\000v\\000{'descr': '<f4', 'fortran_order': False, 'shape': (30, 40), }"
sized h.img 4800 ''
for line in 'samples = 40' 'lines = 30' 'bands = 1' 'data type = 4' 'byte order = 0'; do
    grep -qx "$line" h.hdr || fail "h.hdr lacks '$line'"
done
same h.img h.r32
bytes h.npy 128 4800 | cmp - h.r32 || fail "h.npy and h.r32 have different samples"
from_below >"$notes/expected"
bytes h.pfm 14 4800 | cmp - "$notes/expected" || fail "h.pfm is not h.r32 from the bottom up"
bytes h.pgm 15 2400 | dd conv=swab 2>/dev/null | cmp - h.r16 || fail "h.pgm is not h.r16, swapped"
[ "$(od -A n -v -t x2 h.r16 | tr -s ' ' '\n' | sort -u | wc -l)" -gt 100 ] || fail "h.r16 is flat"

quietly "$@" --normals n.ppm --hillshade s.pgm --gradient g.npy
sized n.ppm $((13 + 3600)) 'P6\n40 30\n255\n'
sized s.pgm $((13 + 1200)) 'P5\n40 30\n255\n'
sized g.npy $((128 + 9600)) '\223NUMPY'
quietly "$@" --normals n.pfm --hillshade s.img --gradient g.img
sized n.pfm $((14 + 14400)) 'PF\n40 30\n-1.0\n'
bytes s.pgm 13 1200 | cmp - s.img || fail "s.pgm and s.img have different samples"
bytes g.npy 128 9600 | cmp - g.img || fail "g.npy and g.img have different samples"

# PNG where zlib was found
if scarp info | grep -q '^formats .*png'; then
    quietly "$@" --output t
    printf IEND >"$notes/iend"
    for name in t-height t-normal t-hillshade; do
        [ "$(bytes "$name.png" 0 24 | od -A n -v -t u1 | tr -s '[:space:]' ' ')" = \
            " 137 80 78 71 13 10 26 10 0 0 0 13 73 72 68 82 0 0 0 40 0 0 0 30 " ] ||
            fail "the header of $name.png"
        tail -c 8 "$name.png" | head -c 4 | cmp - "$notes/iend" || fail "the end of $name.png"
    done
else
    refused 2 --heights terrain "$@" --heights t.png
    quietly "$@" --output t
    same t-height.pgm h.pgm
    same t-normal.ppm n.ppm
    same t-hillshade.pgm s.pgm
fi

# Neither threads nor instruction sets nor standard output change a byte.
quietly "$@" --heights one.r32 --threads 1
same one.r32 h.r32
quietly "$@" --heights scalar.r32 --isa scalar
same scalar.r32 h.r32
scarp terrain "$@" --quiet --heights r32:- | cmp - h.r32 || fail "standard output gets other bytes"
quietly "$@" --seed 2 --heights other.r32
! cmp -s other.r32 h.r32 || fail "another seed gives the same heights"
