# SPDX-License-Identifier: MIT
"""Levels of detail and band limits."""
import json
import math
import os
import re

import common
from common import Case, run
from rasters import FLOAT, Picture, envi_corner, read_picture

NOISE = ("--frequency", "0.02", "--octaves", "7", "--gain", "0.6", "--rotate")


def up(a, b):
    return -(-a // b)


class Levels(Case):
    def floats(self, name, width, height):
        return Picture(width, height, 1, FLOAT, self.bytes(name)).rows

    def level(self, k, width, height, step, x, y, *arguments):
        """Level k by its definition: samples in the middle of blocks that are counted from the top
        left corner, and octaves limited to their step."""
        side = 2 ** k
        w, h = up(width, side), up(height, side)
        inward = (side - 1) / 2 * step
        top = y + (height - 1) * step - inward
        limit = ["--band-limit"] if k > 0 else []
        self.quietly("--size", "%dx%d" % (w, h), "--step", repr(side * step), "--origin",
                     "%r,%r" % (x + inward, top - (h - 1) * side * step), "--heights", "one.r32",
                     *limit, *arguments)
        return self.floats("one.r32", w, h)

    def test_samples(self):
        """Each level is, to the bit, a raster of its own, whatever the size."""
        for width, height, step, x, y in ((64, 32, 1, 0, 0), (37, 50, 0.25, -70, 1000),
                                          (1, 40, 4, 3.5, -8)):
            self.quietly(*NOISE, "--size", "%dx%d" % (width, height), "--step", repr(step),
                         "--origin", "%r,%r" % (x, y), "--levels", "5", "--heights", "h.r32")
            for k in range(5):
                name = "h-level%d.r32" % k if k else "h.r32"
                self.check_rows(self.floats(name, up(width, 2 ** k), up(height, 2 ** k)),
                                self.level(k, width, height, step, x, y, *NOISE))

    def test_level_0(self):
        """It is the raster without --levels, unless --band-limit is given."""
        for more in ((), ("--band-limit",)):
            self.quietly(*NOISE, "--size", "40x30", *more, "--heights", "a.r32", "--relief", "a.npy")
            self.quietly(*NOISE, "--size", "40x30", *more, "--levels", "2", "--heights", "b.r32",
                         "--relief", "b.npy")
            for end in ("r32", "npy"):
                self.assertEqual(self.bytes("a." + end), self.bytes("b." + end))

    def test_band_limit(self):
        """Octaves whose cells are smaller than two samples are left out; one between fades; the
        others stay as they are."""
        size = ("--size", "32x32", "--frequency", "0.125", "--gain", "0.5")  # cells of 8, 4, 2 ...
        def raster(*arguments):
            self.quietly(*size, *arguments, "--heights", "h.r32")
            return self.bytes("h.r32")
        self.assertEqual(raster("--octaves", "6", "--band-limit"),
                         raster("--octaves", "3", "--of-octaves", "6"))
        self.assertEqual(raster("--octaves", "6", "--step", "2", "--band-limit"),
                         raster("--octaves", "2", "--of-octaves", "6", "--step", "2"))
        self.assertEqual(raster("--octaves", "6", "--step", "1.5", "--band-limit"),
                         raster("--octaves", "2.5", "--of-octaves", "6", "--step", "1.5"))
        self.assertEqual(raster("--octaves", "2", "--band-limit"), raster("--octaves", "2"))

    def test_means(self):
        """A level is near the means of the blocks of the one before, nearer by far than every
        other sample is, and than samples with all octaves are."""
        arguments = (*NOISE, "--size", "128x128", "--height", "100")
        self.quietly(*arguments, "--levels", "4", "--heights", "h.r32")
        full = self.floats("h.r32", 128, 128)
        w = 16
        means = [[sum(full[8 * r + i][8 * c + j] for i in range(8) for j in range(8)) / 64
                  for c in range(w)] for r in range(w)]
        def rms(rows):
            return math.sqrt(sum((a - b) ** 2 for row, other in zip(rows, means)
                                 for a, b in zip(row, other)) / w / w)
        corners = rms([row[::8] for row in full[::8]])
        middles = rms([row[4::8] for row in full[4::8]])
        level = rms(self.floats("h-level3.r32", w, w))
        self.assertLess(level, 0.5 * corners)
        self.assertLess(level, 0.7 * middles)

    def test_scale_and_colours(self):
        """All levels have the 16-bit scale and the colours of level 0."""
        result = run("terrain", *NOISE, "--size", "64x64", "--levels", "3", "--heights", "h.pgm",
                     "--relief", "c.npy", cwd=self.directory)
        self.assertEqual(result.returncode, 0)
        lowest, highest = map(float, re.search(rb"16-bit heights: 0 is (\S+), 65535 is (\S+)\n",
                                               result.stdout).groups())
        self.assertEqual(result.stdout.count(b"16-bit"), 1)
        self.assertRegex(result.stdout.decode(), r"(?m)^64x64 in 3 levels, 5376 samples in ")
        self.quietly(*NOISE, "--size", "64x64", "--levels", "3", "--heights", "h.r32")
        for name, w in (("h", 64), ("h-level1", 32), ("h-level2", 16)):
            greys = read_picture(self.path(name + ".pgm")).flat()
            for grey, row in zip(greys, sum(self.floats(name + ".r32", w, w), [])):
                self.assertLess(abs(65535 * (row - lowest) / (highest - lowest) - grey), 0.51)
        mean = [[sum(colour[i] for colour in read_picture(self.path(name)).flat()) / w / w
                 for i in range(3)] for name, w in (("c.npy", 64), ("c-level2.npy", 16))]
        for one, other in zip(*mean):
            self.assertLess(abs(one - other), 12)

    def test_tiles(self):
        """Tiles of each level make up the level, and shares those of all levels."""
        arguments = (*NOISE, "--size", "50x37", "--levels", "3")
        self.quietly(*arguments, "--heights", "h.img")
        whole = [read_picture(self.path(name)).rows for name in
                 ("h.img", "h-level1.img", "h-level2.img")]
        corner = envi_corner(self.bytes("h-level2.hdr").decode())
        self.assertEqual(corner, (-0.5, 36.5, 4.0))
        self.clear()
        for share in ("2/3", "0/3", "1/3"):
            self.quietly(*arguments, "--tile", "16x16", "--share", share, "--heights",
                         "{level}/{y}/{x}.img")
        for k, rows in enumerate(whole):
            w, h = len(rows[0]), len(rows)
            made = []
            for y in range(up(h, 16)):
                tiles = [read_picture(self.path("%d/%d/%d.img" % (k, y, x))).rows
                         for x in range(up(w, 16))]
                made += [sum(parts, []) for parts in zip(*tiles)]
            self.check_rows(made, rows)
        with open(self.path("level_y_x.img.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["levels"], 3)
        result = run("terrain", *arguments, "--tile", "16x16", "--resume", "--heights",
                     "{level}/{y}/{x}.img", cwd=self.directory)
        self.assertEqual(result.stdout, b"nothing to do: all files are there\n")
        os.remove(self.path("1/1/0.img"))
        result = run("terrain", *arguments, "--tile", "16x16", "--resume", "--heights",
                     "{level}/{y}/{x}.img", cwd=self.directory)
        self.assertIn(b"\n1 tile, 48 samples", b"\n" + result.stdout)

    def test_names(self):
        for pattern, names in (("w.r32", ["w_0_0.r32", "w-level1_0_0.r32", "w-level2_0_0.r32"]),
                               ("{y}{x}.r32", ["00.r32", "00-level1.r32", "00-level2.r32"]),
                               ("{-level:02}-{x}{y}.r32", ["02-00.r32", "01-00.r32", "00-00.r32"])):
            self.clear()
            self.quietly("--size", "8x8", "--tile", "8x8", "--levels", "3", "--heights", pattern)
            self.assertEqual([name for name in self.files() if name.endswith(".r32")],
                             sorted(names))
        self.clear()
        self.quietly("--size", "8x8", "--levels", "3", "--heights", "l{level}.r32")
        self.assertEqual(self.files(), ["l0.r32", "l1.r32", "l2.r32"])

    def test_refused(self):
        for arguments, words in (
                (("--levels", "0"), ("--levels", "from 1 to 20")),
                (("--levels", "21"), ("--levels",)),
                (("--levels", "5", "--size", "8x3"), ("--levels: 8x3 samples have 4 levels",)),
                (("--levels", "2", "--tile", "4x4", "--tiles", "0:1,0:1"), ("--tiles", "--share")),
                (("--heights", "l{level}.r32"), ("--heights: {level}", "--levels")),
                (("--levels", "2", "--heights", "{level}{x}.r32"), ("{x}", "--tile")),
                (("--levels", "2", "--heights", "r32:-"), ("--levels", "standard output")),
                (("--levels", "2", "--heights", "r32:/dev/null"), ("--levels", "devices"))):
            if "r32:/dev/null" in arguments and not common.pty:
                continue  # there are no such devices on Windows
            with self.subTest(arguments=arguments):
                result = run("terrain", "--size", "8x8", *arguments, cwd=self.directory)
                self.check_one_line(result, 2, *words)
                self.assertEqual(self.files(), [])
        self.quietly("--levels", "4", "--size", "8x3", "--heights", "h.r32")


common.main(globals())
