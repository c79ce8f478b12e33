# SPDX-License-Identifier: MIT
"""Neither the instruction set nor the number of threads changes a byte."""
import unittest

import common
from common import SMALL, Case, has_png, has_threads, run

class Isa(Case):
    name = None

    def test_same_bytes(self):
        for arguments in ((), ("--rotate", "--basis", "value", "--fade", "cubic"),
                          ("--fractal", "turbulence", "--rotate"), ("--fractal", "ridged"),
                          ("--fractal", "erosion", "--erosion", "2.5", "--fade", "cubic"),
                          ("--origin", "-123456789.5,4e9", "--step", "0.37", "--octaves", "12.3")):
            with self.subTest(arguments=arguments):
                size = ["--size", "131x67", "--frequency", "0.03", *arguments]
                self.assertEqual(self.terrain(*size, "--isa", self.name),
                                 self.terrain(*size, "--isa", "scalar"))

    def test_named(self):
        result = run("terrain", *SMALL, "--isa", self.name, "--output", self.path("t"))
        self.assertIn("(%s, " % self.name, result.stdout.decode())


# Every layer, and every kind of sample that it can have
LAYERS = (("--heights", "h.r32"), ("--heights", "h.r16"), ("--heights", "h.pgm"),
          ("--heights", "h.pfm"), ("--normals", "n.npy"), ("--normals", "n.ppm"),
          ("--hillshade", "s.pgm"), ("--relief", "c.ppm"), ("--gradient", "g.npy"))
PICTURES = (("--heights", "h.png"), ("--normals", "n.png"), ("--hillshade", "s.png"),
            ("--relief", "c.png"))


class Threads(Case):
    """Whatever the number of threads, the files are the same.

    A raster is made in bands of rows, at least four of them and no more than 16 MB each, and a
    band in blocks of 32768 samples: here is no size that they divide.
    """

    COUNTS = ("2", "3", "5", "8")

    def check(self, size, *files):
        arguments = ("--size", size, "--octaves", "2", "--z-factor", "2", *files)
        self.quietly(*arguments, "--threads", "1")
        one = self.all_bytes()
        for count in (*self.COUNTS, None) if has_threads() else (None,):
            with self.subTest(threads=count):
                self.clear()
                self.quietly(*arguments, *(("--threads", count) if count else ()))
                self.check_same_files(self.all_bytes(), one)
        self.clear()

    @unittest.skipUnless(common.SPEED == "full", "slow")
    def test_large(self):
        """More than four bands of 16 MB: 3001 samples are 96 KB of these files."""
        self.check("3001x701", "--heights", "h.r32", "--normals", "n.npy", "--hillshade", "s.img",
                   "--gradient", "g.img", "--output", "t")

    def test_pictures(self):
        self.check("700x401", "--output", "t", "--compare", "2")

    def test_formats(self):
        for option, name in LAYERS + PICTURES * has_png():
            self.check("1999x211", option, name)  # four blocks in a band

    def test_png_beside_others(self):
        """Nor do the files that are made with it, by which bands get another size."""
        if not has_png():
            self.skipTest("needs zlib")
        for size in ("1999x211", "211x1999"):
            arguments = ("--size", size, "--octaves", "2")
            alone = {}
            for option, name in PICTURES:
                self.quietly(*arguments, option, name)
                alone.update(self.all_bytes())
                self.clear()
            self.quietly(*arguments, *[word for pair in PICTURES for word in pair], "--gradient",
                         "g.npy", "--output", "t", "--compare", "7")
            together = self.all_bytes()
            self.check_same_files({name: together[name] for name in alone}, alone)
            self.clear()

    def test_without_threads(self):
        if has_threads():
            self.skipTest("this program has threads")
        for count in ("2", "1024"):
            result = run("terrain", *SMALL, "--threads", count, "--output", self.path("t"))
            self.check_one_line(result, 2, "--threads", "without threads")
        self.assertEqual(self.files(), [])


common.main(globals())
