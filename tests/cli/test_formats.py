# SPDX-License-Identifier: MIT
"""Every format, read back by a reader that shares nothing with the program."""
import math
import os
import re
import zlib

import common
from common import SMALL, Case, has_png, rounded, run, text_of
from rasters import FLOAT, U16_LOW, Picture, envi_corner, png_chunks, read_bytes, read_picture

WIDTH, HEIGHT = 37, 23
PLACE = ("--size", "%dx%d" % (WIDTH, HEIGHT), "--frequency", "0.03", "--origin", "-3.25,1000",
         "--step", "0.5", "--height", "64", "--octaves", "5")
RAW = {"r16": U16_LOW, "r32": FLOAT}
HALF = 0.5 + 1e-6  # what rounding to the nearest may cost
# The formats of each layer as samples: floats first
FORMATS = {"--heights": (("r32", "pfm", "img", "tif", "npy"), ("r16", "pgm", "png")),
           "--normals": (("npy", "pfm", "img", "tif"), ("ppm", "png")),
           "--hillshade": ((), ("pgm", "png", "img", "tif", "npy")),
           "--gradient": (("npy", "img", "tif"), ())}


def formats_of(option, floats):
    return [name for name in FORMATS[option][0 if floats else 1] if name != "png" or has_png()]


class Formats(Case):
    """What is in the files."""

    def read(self, option, kind, *arguments, name=None, shape=(WIDTH, HEIGHT)):
        name = name or "%s.%s" % (option[2:], kind)
        self.layer(option, name, *PLACE, *arguments)
        if kind in RAW:
            return Picture(*shape, 1, RAW[kind], self.bytes(name))
        return read_picture(self.path(name), kind)

    def check_agree(self, option, floats, shape, *arguments):
        """All formats of a layer hold the same samples; returns them."""
        kinds = formats_of(option, floats)
        first = self.read(option, kinds[0], *arguments)
        self.assertEqual(first.shape(), shape)
        for kind in kinds[1:]:
            with self.subTest(format=kind, arguments=arguments):
                other = self.read(option, kind, *arguments)
                self.assertEqual(other.shape(), shape)
                self.check_rows(other.rows, first.rows)
        return first

    def test_heights(self):
        """Integers are the floats over the range that the help names, to the nearest."""
        for arguments, lowest, highest in (
                ((), -1, 1), (("--amplitude", "-2.5"), -2.5, 2.5),
                (("--fractal", "erosion"), -1, 1), (("--fractal", "turbulence"), 0, 1),
                (("--fractal", "ridged", "--amplitude", "-0.25"), -0.25, 0),
                (("--fractal", "ridged", "--sea-level", "0.25"), 0.25, 1),
                (("--plateau", "0.125"), -1, 0.125),
                (("--sea-level", "-0.1", "--plateau", "0.06"), rounded(-0.1), rounded(0.06))):
            with self.subTest(arguments=arguments):
                floats = self.check_agree("--heights", True, (WIDTH, HEIGHT, 1, 32), *arguments)
                greys = self.check_agree("--heights", False, (WIDTH, HEIGHT, 1, 16), *arguments)
                self.assertGreater(len(set(floats.flat())), 100)
                for height, grey in zip(floats.flat(), greys.flat()):
                    value = height / 64  # exact
                    self.assertLessEqual(
                        abs(65535 * (value - lowest) / (highest - lowest) - grey), HALF)

    def test_normals(self):
        """Unit vectors, perpendicular to the gradient; bytes follow from the floats exactly."""
        floats = self.check_agree("--normals", True, (WIDTH, HEIGHT, 3, 32))
        colours = self.check_agree("--normals", False, (WIDTH, HEIGHT, 3, 8))
        gradient = self.read("--gradient", "npy")
        for n, colour, (dx, dy) in zip(floats.flat(), colours.flat(), gradient.flat()):
            self.assertLess(abs(math.hypot(*n) - 1), 3e-7)
            length = math.hypot(dx, dy, 1)
            for part, expected in zip(n, (-dx / length, -dy / length, 1 / length)):
                self.assertLess(abs(part - expected), 3e-7)
            self.assertEqual(colour, tuple(math.floor(127.5 * part + 128) for part in n))

    def test_hillshade(self):
        self.check_agree("--hillshade", False, (WIDTH, HEIGHT, 1, 8))

    def test_gradient(self):
        """The slopes of the floats next to it: x grows to the right, y upward."""
        gradient = self.check_agree("--gradient", True, (WIDTH, HEIGHT, 2, 32), "--octaves", "1")
        z = self.read("--heights", "r32", "--octaves", "1").rows
        steepest = [max(abs(slope[i]) for slope in gradient.flat()) for i in (0, 1)]
        for r in range(1, HEIGHT - 1):
            for c in range(1, WIDTH - 1):
                dx, dy = gradient.rows[r][c]
                self.assertLess(abs(z[r][c + 1] - z[r][c - 1] - dx), 0.01 * steepest[0])
                self.assertLess(abs(z[r - 1][c] - z[r + 1][c] - dy), 0.01 * steepest[1])

    def check_parts(self, data, line):
        """The parts of a PNG: each a chunk and some whole lines, as many in all but the last, which
        need nothing of those before: only so can several threads make them at a time."""
        header, *parts, checksum = [body for name, body in png_chunks(data) if name == b"IDAT"]
        self.assertEqual((header, len(checksum)), (b"\x78\x01", 4))
        self.assertGreaterEqual(len(parts), 5)
        lengths = []
        for number, part in enumerate(parts, 1):
            inflater = zlib.decompressobj(-15)
            raw = inflater.decompress(part)
            self.assertEqual((inflater.eof, inflater.unused_data), (number == len(parts), b""))
            self.assertEqual(len(raw) % line, 0)
            lengths.append(len(raw))
        self.assertEqual(len(set(lengths[:-1])), 1)
        self.assertLessEqual(lengths[-1], lengths[0])
        self.assertLessEqual(lengths[0], 1.01 * (128 << 10))
        self.assertGreater(lengths[0], 16 << 10)

    def test_png_parts(self):
        """Many parts and more than one band, in each of which rows follow on the one above."""
        if not has_png():
            self.skipTest("needs zlib")
        width, height = 700, 401
        for option, kind, pixel in (("--heights", "pgm", 2), ("--normals", "ppm", 3),
                                    ("--hillshade", "pgm", 1)):
            size = ("--size", "%dx%d" % (width, height), "--octaves", "2")
            picture = self.read(option, "png", *size)
            self.check_rows(picture.rows, self.read(option, kind, *size).rows)
            self.check_parts(self.bytes(option[2:] + ".png"), 1 + width * pixel)

    def test_png_wide(self):
        """A row that is larger than a part"""
        if not has_png():
            self.skipTest("needs zlib")
        size = ("--size", "50000x21", "--octaves", "1")
        self.check_rows(self.read("--normals", "png", *size).rows,
                        self.read("--normals", "ppm", *size).rows)

    def test_least(self):
        """Rasters of one row, one column, one sample."""
        for width, height in ((1, 1), (5, 1), (1, 5), (2, 3)):
            size = ("--size", "%dx%d" % (width, height), "--frequency", "0.3")
            for option in FORMATS:
                for floats in (True, False):
                    pictures = [self.read(option, kind, *size, shape=(width, height))
                                for kind in formats_of(option, floats)]
                    for picture in pictures:
                        self.assertEqual((picture.width, picture.height), (width, height))
                        self.check_rows(picture.rows, pictures[0].rows)

    def test_envi_place(self):
        """Half a step to the left of and above the first sample, which is the top left one."""
        self.read("--heights", "img")
        self.assertEqual(envi_corner(self.bytes("heights.hdr").decode()),
                         (-3.25 - 0.25, 1000 + (HEIGHT - 1) * 0.5 + 0.25, 0.5))
        self.assertEqual(self.files(), ["heights.hdr", "heights.img"])

    def test_prefix(self):
        """What is before the colon is the format, whatever the extension."""
        for text, kind, name in (("r32:t", "r32", "t"), ("npy:t.pgm", "npy", "t.pgm"),
                                 ("R16:t.raw", "r16", "t.raw"), ("r32:a:b", "r32", "a:b"),
                                 ("img:t.bin", "img", "t.bin"), ("a:b.npy", "npy", "a:b.npy")):
            with self.subTest(text=text):
                expected = self.layer("--heights", "plain." + kind, *PLACE)
                self.clear()
                self.quietly(*PLACE, "--heights", text)
                self.assertEqual(self.files(), sorted([name] + [name + ".hdr"] * (kind == "img")))
                self.assertEqual(self.bytes(name), expected)
                self.clear()

    def test_capitals(self):
        for kind in formats_of("--heights", True) + formats_of("--heights", False):
            with self.subTest(format=kind):
                name = "T." + kind.upper()
                self.assertEqual(self.layer("--heights", name, *PLACE),
                                 self.layer("--heights", "u." + kind, *PLACE))

    def test_together(self):
        """Files made in one pass are those made one by one."""
        single = {}
        files = [("--heights", "h." + kind) for kind in ("r32", "r16", "pgm", "pfm", "img")]
        files += [("--normals", "n." + kind) for kind in ("npy", "ppm", "pfm", "img")]
        files += [("--hillshade", "s.pgm"), ("--hillshade", "s.img"), ("--gradient", "g.npy"),
                  ("--output", "t")]
        for pair in files:
            self.quietly(*PLACE, "--z-factor", "3", "--sea-level", "0.05", *pair)
            single[pair] = self.all_bytes()
            self.clear()
        for combination in ((0, 5), (1, 9), (2, 11), (3, 10), (4, 8), (6, 9), (7, 10, 11), (5, 12),
                            (0, 6, 9, 11), (3, 7, 10, 11, 12), (4, 8, 10, 11, 12)):
            pairs = [files[i] for i in combination]
            with self.subTest(files=pairs):
                self.quietly(*PLACE, "--z-factor", "3", "--sea-level", "0.05",
                             *[word for pair in pairs for word in pair])
                expected = {}
                for pair in pairs:
                    expected.update(single[pair])
                self.check_same_files(self.all_bytes(), expected)
            self.clear()

    def test_compare_and_all(self):
        """As many files as there can be: each layer by itself, STEM's three and the comparison."""
        self.quietly(*SMALL, "--output", "t", "--compare", "2")
        expected = self.all_bytes()
        pairs = (("--heights", "h.r32"), ("--normals", "n.npy"), ("--hillshade", "s.pgm"),
                 ("--gradient", "g.npy"))
        for option, name in pairs:
            expected[name] = self.layer(option, name, *SMALL)
        self.clear()
        self.quietly(*SMALL, "--output", "t", "--compare", "2",
                     *[word for pair in pairs for word in pair])
        self.check_same_files(self.all_bytes(), expected)


class Names(Case):
    """File names that cannot be written: nothing may be done."""

    def check(self, arguments, *words):
        with self.subTest(arguments=arguments):
            result = run("terrain", *SMALL, *arguments, cwd=self.directory)
            error = self.check_one_line(result, 2, *words)
            self.assertEqual(self.files(), [])
            return error

    def test_unknown(self):
        """The message names the formats of the layer, which are those of its help."""
        text = text_of("terrain", "--help")
        for option in FORMATS:
            entry = re.search(r"\n  %s (?s:.*?)(?=\n  --)" % option, text).group()
            kinds = re.findall(r"\.(\w+)", entry)
            expected = {kind for both in FORMATS[option] for kind in both}
            self.assertEqual(set(kinds), expected)
            expected -= set() if has_png() else {"png"}
            for name in ("t", "t.jpg", ".npy", "npy", "png:", "npy:", "jpg:t", "t.npy/t", "t.npyx",
                         "t.npy.", ":t", "-", "t.n"):
                error = self.check((option, name), option, repr(name))
                self.assertEqual(set(re.findall(r" \.(\w+)", error)), expected)

    def test_one_file_by_two_names(self):
        for one, other in (("r32:a", "npy:./a"), ("a.img", "img:a")):
            self.check(("--heights", one, "--normals", other), "--normals", "another option")

    def test_part(self):
        """Another file would pass under that name while it is written."""
        self.check(("--heights", "r32:a.part", "--normals", "npy:a"), "--heights", "a.part")

    def test_kinds(self):
        """A format that has no samples of the layer's kind."""
        for option in FORMATS:
            for kind in {"png", "pgm", "ppm", "r16", "r32", "pfm", "img", "tif", "npy"}:
                if not any(kind in kinds for kinds in FORMATS[option]):
                    self.check((option, "t." + kind), option, "t." + kind)
                    self.check((option, kind + ":t"), option)

    def test_standard_output(self):
        """ENVI is two files, and PFM and TIFF are not written from their start to their end."""
        for kind in ("pfm", "img", "tif"):
            self.check(("--heights", kind + ":-"), "--heights", kind, "standard output")
        self.check(("--heights", "r32:-", "--normals", "npy:-"), "--normals", "--heights",
                   "standard output")

    def test_twice(self):
        self.check(("--heights", "t.npy", "--normals", "t.npy"), "--normals", "--heights", "t.npy")
        self.check(("--hillshade", "pgm:t", "--heights", "r32:t"), "--hillshade", "--heights")
        name = self.names("t")[0]
        self.check(("--output", "t", "--heights", name), "--output", "--heights", name)
        with open(self.path("t.npy"), "wb") as file:  # which may be replaced, but by one only
            file.write(b"old")
        result = run("terrain", *SMALL, "--heights", "t.npy", "--normals", "t.npy",
                     cwd=self.directory)
        self.check_one_line(result, 2, "--normals")
        self.assertEqual(self.all_bytes(), {"t.npy": b"old"})

    def test_comparison_alone(self):
        self.check(("--compare", "1", "--heights", "t.r32"), "--compare", "--output")

    def test_without_zlib(self):
        if has_png():
            self.skipTest("this program has zlib")
        for option in ("--heights", "--normals", "--hillshade"):
            for name in ("t.png", "png:t", "png:-"):
                self.check((option, name), option, "without zlib")

    def test_no_device_for_envi(self):
        """A header next to it would be a file in /dev."""
        if not os.path.exists("/dev/null"):
            self.skipTest("needs /dev/null")
        self.check(("--heights", "img:/dev/null"), "--heights", "/dev/null")
        self.assertFalse(os.path.exists("/dev/null.hdr"))

    def test_only_what_is_asked_for(self):
        """Without --output there are no pictures."""
        self.quietly(*SMALL, "--gradient", "g.npy")
        self.assertEqual(self.files(), ["g.npy"])
        self.assertEqual(len(read_bytes(self.path("g.npy"))), 128 + 40 * 30 * 8)


common.main(globals())
