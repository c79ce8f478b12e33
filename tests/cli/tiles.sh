#!/bin/sh
# SPDX-License-Identifier: MIT
# Tiles are pieces of the whole, byte for byte, and --resume makes those that are missing.
. ./common.sh
set -- --size 24x20 --frequency 0.03 --octaves 4 --rotate --step 0.25

# piece FILE WIDTH SIZE LEFT TOP RIGHT BOTTOM: a part of a raster of that width, with samples of SIZE
# bytes
piece()
{
    row=$5
    while [ "$row" -lt "$7" ]; do
        bytes "$1" $((($2 * row + $4) * $3)) $((($6 - $4) * $3))
        row=$((row + 1))
    done
}

least() # A B
{
    echo $(($1 < $2 ? $1 : $2))
}

# check WIDTH HEIGHT LAST_X LAST_Y: tiles of that size, of heights and gradients
check()
{
    y=0
    while [ $y -le "$4" ]; do
        x=0
        while [ $x -le "$3" ]; do
            set -- "$1" "$2" "$3" "$4" $((x * $1)) $((y * $2)) "$(least $((x * $1 + $1)) 24)" \
                "$(least $((y * $2 + $2)) 20)"
            piece whole.r32 24 4 "$5" "$6" "$7" "$8" | cmp - "h_${y}_$x.r32" ||
                fail "tile $x, $y of the heights"
            piece whole.img 24 8 "$5" "$6" "$7" "$8" | cmp - "g_${y}_$x.img" ||
                fail "tile $x, $y of the gradient"
            x=$((x + 1))
        done
        y=$((y + 1))
    done
}

unchanged() # the tiles are those that were compared with the whole
{
    for file in "$notes"/first/*; do
        same "${file##*/}" "$file"
    done
}

tiles() # every tile that is there, and nothing else
{
    find . -name '[hg]_*.r32' -o -name '[hg]_*.img' | wc -l
}

quietly "$@" --heights whole.r32 --gradient whole.img
quietly "$@" --tile 10x8 --heights h.r32 --gradient g.img
check 10 8 2 2
[ "$(tiles)" -eq 18 ] || fail "3 x 3 tiles of two layers are $(tiles) files"

# One missing file of two, in two tiles: these two are made again.
mkdir "$notes/first"
cp -p [hg]_*.??? "$notes/first"
rm h_0_1.r32 g_2_2.img
touch "$notes/now"
sleep 0.1 # which every clock of a file system shows
quietly "$@" --tile 10x8 --heights h.r32 --gradient g.img --resume
made=$(find . -name '[hg]_*.[ri]*' -newer "$notes/now" | sort | tr -d '\n')
[ "$made" = ./g_0_1.img./g_2_2.img./h_0_1.r32./h_2_2.r32 ] || fail "--resume made $made"
unchanged
[ -z "$(find . -name '*.part')" ] || fail "unfinished files are left: $(ls -A)"

# Tiles of another world are refused; the manifest is that of this one.
refused 2 '--seed is 1 there and 2 here' terrain "$@" --tile 10x8 --heights h.r32 \
    --gradient g.img --seed 2 --resume
unchanged

# Shares are contiguous, and make the same tiles.
rm [hg]_* h.r32.json
for share in 3 1 0 2; do
    quietly "$@" --tile 10x8 --heights h.r32 --gradient g.img --share $share/4
    [ "$share" != 3 ] || [ "$(echo h_*.r32)" = 'h_2_1.r32 h_2_2.r32' ] ||
        fail "--share 3/4 makes $(echo h_*.r32)"
done
unchanged
[ "$(tiles)" -eq 18 ] || fail "four shares of 3 x 3 tiles of two layers are $(tiles) files"

# Patterns put tiles into directories.
quietly "$@" --tile 10x8 --heights 'p/{-y}/{x:03}.r32'
same p/0/002.r32 h_2_2.r32
same p/2/001.r32 h_0_1.r32

# Of a few tiles, only these are made.
rm [hg]_* h.r32.json
quietly "$@" --tile 8x8 --tiles 1:3,2:3 --heights h.r32 --gradient g.img
[ "$(echo h_*.r32)" = 'h_2_1.r32 h_2_2.r32' ] || fail "--tiles 1:3,2:3 makes $(echo h_*.r32)"
piece whole.r32 24 4 16 16 24 20 | cmp - h_2_2.r32 || fail "--tiles makes other tiles"

# Neighbours share the samples of the overlap.
rm [hg]_* h.r32.json
quietly "$@" --tile 10x10 --overlap 2 --heights h.r32
piece whole.r32 24 4 0 0 12 12 | cmp - h_0_0.r32 || fail "the overlap of the first tile"
piece whole.r32 24 4 10 0 22 12 | cmp - h_0_1.r32 || fail "the overlap of the next tile"

refused 2 --tiles terrain "$@" --tile 8x8 --tiles 0:5,0:1 --heights x.r32
refused 2 --share terrain "$@" --tile 8x8 --share 3/3 --heights x.r32
refused 2 '{x}' terrain "$@" --tile 8x8 --heights '{y}.r32'
refused 2 --overlap terrain "$@" --overlap 1 --heights x.r32
