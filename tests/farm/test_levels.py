# SPDX-License-Identifier: MIT
"""The document's pyramid: each level is, to the bit, a raster of its own; and shares of it are the
same files. Its checksums find what was damaged."""
import os

from farm import check, envi_rows, main, rows_of, tell
from rasters import read_bytes

LEVELS = 5


def up(a, b):
    return -(-a // b)


def level_rows(farm, n, width, height):
    """The tiles of a level, put together"""
    level = []
    for y in range(up(height, farm.tile)):
        tiles = [rows_of(farm.path("level%d" % n, str(y), "%d.img" % x))[2]
                 for x in range(up(width, farm.tile))]
        level += [b"".join(parts) for parts in zip(*tiles)]
    return level


def pyramid(new_farm):
    farm = new_farm("levels", slow=False, layers=())
    farm.run("Levels")
    for n in range(LEVELS):
        side = 2 ** n
        width, height = up(farm.width, side), up(farm.height, side)
        inward = (side - 1) / 2
        bottom = farm.height - 1 - inward - (height - 1) * side
        options = dict(farm.options)
        del options["--tile"]
        options.update({"--size": "%dx%d" % (width, height), "--step": str(side),
                        "--origin": "%r,%r" % (inward, bottom), "--heights": "whole%d.img" % n})
        farm.output("scarp", "terrain", *[word for option in options.items() for word in option],
                    *(["--band-limit"] if n > 0 else []), "--quiet")
        _, _, rows = envi_rows(farm.path("whole%d.img" % n))
        check((len(rows[0]) // 4, len(rows)) == (width, height), "size of level", n)
        check(level_rows(farm, n, width, height) == rows, "level", n, "is no raster of its own")
    tell("five levels of %d x %d have the samples of five rasters" % (farm.width, farm.height))
    files = {}
    for directory, _, names in os.walk(farm.path()):
        for name in names:
            if directory != farm.path() and name.endswith((".img", ".hdr")):
                path = os.path.join(directory, name)
                files[path] = read_bytes(path)
                os.remove(path)
    os.remove(farm.path("levellevel_y_x.img.json"))
    for share in range(7):
        farm.start_shell("exec scarp terrain $(cat pyramid) --share %d/7 --quiet" % share)
    for run in farm.runs:
        check(run.wait() == 0, "a share failed")
    check(all(read_bytes(path) == data for path, data in files.items()),
          "shares write other files")
    tell("seven shares at once write the same %d files" % len(files))


def verify(new_farm):
    farm = new_farm("verify", slow=False, layers=())
    farm.run("The simplest farm")
    farm.run("Verify")
    with open(farm.path("tiles", "0", "1.img"), "r+b") as file:
        file.seek(1000)
        byte = file.read(1)
        file.seek(1000)
        file.write(bytes([byte[0] ^ 128]))
    run = farm.start("Verify")
    check(run.wait() == 1, "a damaged tile is not found")
    tell("a bit that changed is found")


def test(new_farm):
    pyramid(new_farm)
    verify(new_farm)


main(test)
