# SPDX-License-Identifier: MIT
"""Tiles are pieces of the whole, byte for byte, and can be made at several times."""
import os
import unittest

import common
from common import Case, run, start
from rasters import FLOAT, U16_LOW, Picture, envi_corner, read_picture

WIDTH, HEIGHT = 40, 30
STEP = 0.25  # a power of two, so that places are exact whatever the origin
NOISE = ("--frequency", "0.03", "--octaves", "4", "--rotate", "--step", str(STEP))
FILES = (("--heights", "h.r32"), ("--normals", "n.npy"), ("--hillshade", "s.img"),
         ("--gradient", "g.npy"))
FLAGS = [word for pair in FILES for word in pair]


def place(width=WIDTH, height=HEIGHT, x=-70.0, y=1000.0):
    return ("--size", "%dx%d" % (width, height), "--origin", "%r,%r" % (x, y), *NOISE)


def numbered(name, x, y):
    stem, dot, extension = name.rpartition(".")
    return "%s_%d_%d%s%s" % (stem, y, x, dot, extension)


def quotient_up(a, b):
    return -(-a // b)


class TileCase(Case):
    def files(self):
        """Without the manifest, which test_world.py tests"""
        return [name for name in super().files() if not name.endswith(".json")]

    def picture(self, name, width, height):
        path = self.path(name)
        if name.endswith((".r32", ".r16")):
            return Picture(width, height, 1, FLOAT if name.endswith("2") else U16_LOW,
                           self.bytes(name))
        picture = read_picture(path)
        self.assertEqual((picture.width, picture.height), (width, height), name)
        return picture

    def whole(self, files, width, height, **more):
        """The rows of one raster, by file name."""
        self.quietly(*place(width, height, **more), *[word for pair in files for word in pair])
        rows = {name: self.picture(name, width, height).rows for _, name in files}
        self.clear()
        return rows

    def check_tiles(self, files, tile, tiles=None, overlap=0, size=(WIDTH, HEIGHT)):
        """Makes tiles, and cuts the same out of a raster that has room for the overlap: its bottom
        left sample lies further down."""
        width, height = size
        rows = self.whole(files, width + overlap, height + overlap, y=1000 - overlap * STEP)
        arguments = ["--tile", "%dx%d" % tile]
        if overlap:
            arguments += ["--overlap", str(overlap)]
        if tiles:
            arguments += ["--tiles", "%d:%d,%d:%d" % tiles]
        self.quietly(*place(*size), *arguments, *[word for pair in files for word in pair])
        x0, x1, y0, y1 = tiles or (0, quotient_up(width, tile[0]), 0, quotient_up(height, tile[1]))
        names = []
        for y in range(y0, y1):
            for x in range(x0, x1):
                left, top = x * tile[0], y * tile[1]
                right, bottom = min(left + tile[0], width) + overlap, min(top + tile[1],
                                                                          height) + overlap
                for _, name in files:
                    names.append(numbered(name, x, y))
                    names += [numbered(name, x, y)[:-3] + "hdr"] * name.endswith(".img")
                    made = self.picture(numbered(name, x, y), right - left, bottom - top)
                    self.check_rows(made.rows, [row[left:right] for row in rows[name][top:bottom]])
        self.assertEqual(self.files(), sorted(names))
        self.clear()


class Tiles(TileCase):
    """What is in tiles and what they are called."""

    def test_sizes(self):
        for tile in ((10, 10), (7, 11), (40, 30), (39, 29), (64, 31), (1000000, 1000000), (13, 30),
                     (40, 1)):
            with self.subTest(tile=tile):
                self.check_tiles(FILES, tile)

    def test_single_samples(self):
        self.check_tiles(FILES[:2], (1, 1), size=(5, 4))
        self.check_tiles(FILES[:2], (1, 2), size=(5, 3), overlap=1)

    def test_bands(self):
        """The whole is made in four bands, the last one lower, of two by two blocks; tiles are
        not."""
        self.check_tiles((("--heights", "h.r32"), ("--normals", "n.ppm")), (150, 50),
                         size=(600, 401))

    def test_integers(self):
        self.check_tiles((("--heights", "h.r16"), ("--normals", "n.ppm")), (16, 16))
        self.check_tiles((("--heights", "h.pgm"), ("--normals", "n.pfm")), (16, 16), overlap=1)

    def test_overlap(self):
        """Neighbours share samples; the last tiles go beyond the raster."""
        for tile, overlap in (((16, 16), 1), ((10, 10), 1), ((9, 14), 3), ((8, 8), 20),
                              ((64, 64), 5)):
            with self.subTest(tile=tile, overlap=overlap):
                self.check_tiles(FILES, tile, overlap=overlap)
        self.check_tiles(FILES[:1], (3, 2), overlap=100, size=(4, 3))

    def test_slivers(self):
        """A warning names tiles that hold no more than the overlap, and the size that has none."""
        for size, tile, overlap, told in (
                ("33x33", "16x16", "1", "33x33 leaves slivers at the right and at the bottom, which are "
                 "no larger than the --overlap; 32x32 leaves none"),
                ("33x32", "16x16", "1", "at the right, which are no larger than the --overlap; 32x32"),
                ("40x33", "16x16", "1", "at the bottom, which are no larger than the --overlap; 40x32"),
                ("35x20", "16x16", "3", "at the right, which are no larger than the --overlap; 32x20"),
                ("32x32", "16x16", "1", None), ("35x35", "16x16", "1", None),
                ("33x33", "16x16", "0", None), ("1x1", "16x16", "1", None)):
            with self.subTest(size=size, tile=tile, overlap=overlap):
                words = ("--size", size, "--tile", tile, "--overlap", overlap, "--heights", "h.r32")
                result = run("terrain", *words, cwd=self.directory)
                self.assertEqual(result.returncode, 0)
                if told:
                    self.assertRegex(result.stderr.decode(), r"\Ascarp: --size: [^\n]*%s[^\n]*\n\Z" % told)
                else:
                    self.assertEqual(result.stderr, b"")
                self.quietly(*words, "--resume")
                self.clear()

    def test_some(self):
        for tiles in ((0, 1, 0, 1), (1, 3, 0, 2), (3, 4, 2, 3), (0, 4, 1, 2)):
            with self.subTest(tiles=tiles):
                self.check_tiles(FILES, (11, 13), tiles=tiles)
        self.check_tiles(FILES, (11, 13), tiles=(2, 4, 1, 3), overlap=1)

    def test_names(self):
        """NAME_y_x before the extension, if there is one."""
        os.mkdir(self.path("d.d"))
        for text, names in (("r32:h", ("h_0_0", "h_0_1")), ("h.v1.npy", ("h.v1_0_0.npy",
                                                                       "h.v1_0_1.npy")),
                            ("r32:h.raw", ("h_0_0.raw", "h_0_1.raw")),
                            ("r32:d.d/h", ("d.d/h_0_0", "d.d/h_0_1")),
                            ("r32:.h", (".h_0_0", ".h_0_1")),
                            ("img:h", ("h_0_0", "h_0_0.hdr", "h_0_1", "h_0_1.hdr"))):
            with self.subTest(text=text):
                self.quietly("--size", "4x2", "--tile", "2x2", "--heights", text)
                for name in (*names, text.split(":")[-1] + ".json"):
                    os.remove(self.path(name))
                left = super().files() + os.listdir(self.path("d.d"))
                self.assertEqual([name for name in left if not name.endswith(".sums")], ["d.d"])

    def test_stem(self):
        self.quietly(*place(), "--tile", "20x30", "--output", "t", "--compare", "1")
        self.assertEqual(self.files(), sorted(numbered(name, x, 0) for x in (0, 1) for name in
                                              (*self.names("t"),
                                               "t-compare" + self.extensions[1])))

    def test_comparison(self):
        """Differences reach into the neighbours."""
        name = "t-compare" + self.extensions[1]
        self.quietly(*place(), "--output", "t", "--compare", "1")
        whole = read_picture(self.path(name)).rows
        self.quietly(*place(), "--tile", "20x10", "--output", "t", "--compare", "1")
        for x in (0, 1):
            for y in (0, 1, 2):
                tile = read_picture(self.path(numbered(name, x, y)))
                self.check_rows(tile.rows, [row[20 * x:20 * x + 20] + row[40 + 20 * x:60 + 20 * x]
                                            for row in whole[10 * y:10 * y + 10]])

    def test_envi_place(self):
        """A tile knows where it lies, as the whole does, whatever the overlap."""
        self.quietly(*place(), "--heights", "h.img")
        left, top, step = envi_corner(self.bytes("h.hdr").decode())
        self.assertEqual((left, top, step), (-70 - STEP / 2, 1000 + (HEIGHT - 0.5) * STEP, STEP))
        for overlap in ("0", "1"):
            self.clear()
            self.quietly(*place(), "--tile", "16x16", "--overlap", overlap, "--heights", "h.img")
            for x in (0, 1, 2):
                for y in (0, 1):
                    corner = envi_corner(self.bytes("h_%d_%d.hdr" % (y, x)).decode())
                    self.assertEqual(corner, (left + 16 * x * STEP, top - 16 * y * STEP, STEP))

    def test_refused(self):
        for arguments, words in (
                (("--tiles", "0:1,0:1"), ("--tiles", "needs --tile")),
                (("--overlap", "1"), ("--overlap", "needs --tile")),
                (("--tile", "10x10", "--tiles", "0:5,0:1"), ("--tiles", "4 x 3")),
                (("--tile", "10x10", "--tiles", "0:1,2:4"), ("--tiles", "4 x 3")),
                (("--tile", "10x10", "--tiles", "4:5,0:1"), ("--tiles",)),
                (("--tile", "7x7", "--tiles", "0:7,0:1"), ("--tiles", "6 x 5")),
                (("--tile", "40x30", "--tiles", "0:2,0:1"), ("--tiles", "1 x 1")),
                (("--tile", "10x10", "--normals", "npy:-"), ("--tile", "standard output"))):
            with self.subTest(arguments=arguments):
                result = run("terrain", *place(), *arguments, "--heights", "h.r32", "--quiet",
                             cwd=self.directory)
                self.check_one_line(result, 2, *words)
                self.assertEqual(self.files(), [])


class Resume(TileCase):
    """What is there already stays, and the rest is made."""

    ARGUMENTS = (*place(), "--tile", "10x10", "--overlap", "1", *FLAGS)

    def state(self):
        """What changes when a file is written again"""
        found = {}
        for name in self.files():
            status = os.stat(self.path(name))
            found[name] = (status.st_ino, status.st_mtime_ns)
        return found

    def test_nothing_to_do(self):
        self.quietly(*self.ARGUMENTS)
        self.assertEqual(len(self.files()), 12 * 5)
        before, contents = self.state(), self.all_bytes()
        self.quietly(*self.ARGUMENTS, "--resume")
        self.assertEqual(self.state(), before)
        self.quietly(*self.ARGUMENTS)  # and without it, all are made again
        self.assertEqual({name for name, state in self.state().items() if state == before[name]},
                         set())
        self.check_same_files(self.all_bytes(), contents)

    def test_missing(self):
        """A tile of which one file is missing is made again, all of it."""
        self.quietly(*self.ARGUMENTS)
        before, contents = self.state(), self.all_bytes()
        for name in ("h_0_1.r32", "n_1_2.npy", "s_2_3.img", "g_2_3.npy"):
            os.remove(self.path(name))
        self.quietly(*self.ARGUMENTS, "--resume")
        self.check_same_files(self.all_bytes(), contents)
        changed = {name for name, state in self.state().items() if state != before[name]}
        self.assertEqual({name.split(".")[0][1:] for name in changed}, {"_0_1", "_1_2", "_2_3"})
        self.assertEqual(len(changed), 3 * 5)

    def test_one_raster(self):
        """It is one tile."""
        self.quietly(*place(), "--output", "t", "--resume")
        before = self.state()
        self.assertEqual(len(before), 4)
        self.quietly(*place(), "--output", "t", "--resume")
        self.assertEqual(self.state(), before)

    def test_damaged(self):
        """A file that lost or gained bytes is made again, with its tile."""
        names = ["r16", "r32", "pgm", "pfm", "img", "npy"] + ["png"] * common.has_png()
        for kind in names:
            with self.subTest(format=kind):
                arguments = (*place(), "--tile", "20x30", "--heights", "h." + kind)
                self.quietly(*arguments)
                contents = self.all_bytes()
                whole = contents["h_0_0." + kind]
                for damaged in (whole[:-1], b"", whole + b"x"):
                    with open(self.path("h_0_0." + kind), "wb") as file:
                        file.write(damaged)
                    before = self.state()
                    self.quietly(*arguments, "--resume")
                    self.check_same_files(self.all_bytes(), contents)
                    self.assertEqual(before["h_0_1." + kind], self.state()["h_0_1." + kind])
                self.clear()

    def test_damaged_header(self):
        arguments = (*place(), "--tile", "20x30", "--heights", "h.img", "--resume")
        self.quietly(*arguments)
        contents = self.all_bytes()
        for damaged in (contents["h_0_1.hdr"][:-1], contents["h_0_0.hdr"]):
            with open(self.path("h_0_1.hdr"), "wb") as file:
                file.write(damaged)
            self.quietly(*arguments)
            self.check_same_files(self.all_bytes(), contents)

    def test_unfinished_file(self):
        """What a run that was killed left behind is no file."""
        self.quietly(*self.ARGUMENTS)
        contents = self.all_bytes()
        os.remove(self.path("h_1_1.r32"))
        for name in ("h_1_1.r32.part", "s_1_1.hdr.elsewhere-1-0123456789abcdef.part"):
            with open(self.path(name), "wb") as file:
                file.write(b"half" * 1000)
            contents[name] = b"half" * 1000  # may be the user's own, or of another machine
        self.quietly(*self.ARGUMENTS, "--resume")
        self.check_same_files(self.all_bytes(), contents)

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_killed(self):
        """In the middle of a tile: a named pipe in place of one file holds the run there."""
        self.quietly(*self.ARGUMENTS)
        contents = self.all_bytes()
        self.clear()
        os.mkfifo(self.path("n_1_2.npy"))
        process = start("terrain", *self.ARGUMENTS, "--quiet", cwd=self.directory)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for_unfinished("h_1_2.r32")
        self.wait_for(lambda: os.path.exists(self.path("g_1_1.npy")))  # on the disk meanwhile
        process.kill()
        process.wait()
        os.remove(self.path("n_1_2.npy"))
        left = self.all_bytes()
        self.assertEqual(len(self.unfinished("h_1_2.r32")), 1)
        done = {name: data for name, data in left.items() if not name.endswith(".part")}
        self.assertEqual(len(done), 6 * 5, sorted(done))
        self.check_same_files(done, {name: contents[name] for name in done})
        before = self.state()
        self.quietly(*self.ARGUMENTS, "--resume")
        self.check_same_files(self.all_bytes(), contents)
        after = self.state()
        self.assertEqual([name for name in done if before[name] != after[name]], [])

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_killed_anywhere(self):
        """At any time: whatever has its name is complete."""
        arguments = ("--size", "600x600", "--octaves", "24", "--tile", "64x64", "--heights",
                     "h.r32", "--hillshade", "s.img", "--threads", "1")
        self.quietly(*arguments)
        contents = self.all_bytes()
        self.clear()
        for tile in ("s_0_0.img", "s_4_3.img", "s_7_7.img"):
            process = start("terrain", *arguments, "--quiet", "--resume", cwd=self.directory)
            self.addCleanup(process.communicate)
            self.wait_for(lambda: os.path.exists(self.path(tile)), tile)
            process.kill()
            process.wait()
            done = {name: self.bytes(name) for name in self.files() if not name.endswith(".part")}
            self.assertIn(tile, done)
            self.check_same_files(done, {name: contents[name] for name in done})
        self.quietly(*arguments, "--resume")
        self.check_same_files(self.all_bytes(), contents)

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_remains(self):
        """What killed runs left goes, though all tiles are there."""
        arguments = (*place(), "--tile", "10x10", "--heights", "h.r32", "--normals", "n.npy")
        os.mkfifo(self.path("n_0_2.npy"))
        process = start("terrain", *arguments, "--quiet", cwd=self.directory)
        self.addCleanup(process.communicate)
        self.wait_for_unfinished("h_0_2.r32")
        self.wait_for(lambda: os.path.exists(self.path("n_0_1.npy")))
        process.kill()
        process.wait()
        left = self.unfinished()
        self.assertEqual(len(left), 1)
        os.rename(self.path(left[0]), self.path("kept"))
        os.remove(self.path("n_0_2.npy"))
        self.quietly(*arguments, "--resume")
        os.rename(self.path("kept"), self.path(left[0]))
        self.quietly(*arguments, "--resume")
        self.assertEqual(self.unfinished(), [])


common.main(globals())
