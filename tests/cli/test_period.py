# SPDX-License-Identifier: MIT
"""Terrain that repeats."""
import common
from common import Case, run
from rasters import read_picture


class Period(Case):
    """Copies fit side by side, heights, normals and hillshade alike."""

    def make(self, name, *arguments):
        result = run("terrain", *arguments, "--quiet", "--heights", name + ".r16", "--normals",
                     name + ".ppm", "--hillshade", name + ".pgm", cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def check_copies(self, across, down, *arguments, exact=True):
        """A raster of three by two periods is six copies of one of a period."""
        self.make("one", *arguments, "--size", "%dx%d" % (across, down), "--tileable")
        self.make("six", *arguments, "--size", "%dx%d" % (3 * across, 2 * down), "--period",
                  "%dx%d" % (across, down))
        for extension in (".r16", ".ppm", ".pgm"):
            one = self.rows("one" + extension, across, down)
            six = self.rows("six" + extension, 3 * across, 2 * down)
            copies = [row * 3 for row in one] * 2
            if exact:
                self.assertEqual(six, copies, extension)
            else:
                off = max(abs(a - b) for x, y in zip(six, copies) for a, b in zip(x, y))
                self.assertLessEqual(off, 1, extension)

    def rows(self, name, width, height):
        """Rows of bytes, or of 16-bit numbers."""
        with open(self.path(name), "rb") as file:
            data = file.read()
        if name.endswith(".r16"):
            samples = [data[i] + 256 * data[i + 1] for i in range(0, len(data), 2)]
            return [samples[i * width:(i + 1) * width] for i in range(height)]
        picture = read_picture(self.path(name))
        self.assertEqual((picture.width, picture.height), (width, height))
        return [[c for p in row for c in (p if isinstance(p, tuple) else (p,))]
                for row in picture.rows]

    def test_copies(self):
        """To the bit where sides and steps are powers of two."""
        self.check_copies(64, 32)
        for arguments in (["--fractal", "swiss", "--octaves", "6", "--frequency", "0.05"],
                          ["--fractal", "erosion", "--sea-level", "0.05", "--frequency", "0.03"],
                          ["--basis", "value", "--lacunarity", "3", "--octaves", "5",
                           "--frequency", "0.1"]):
            with self.subTest(arguments=arguments):
                self.check_copies(64, 32, *arguments)
        self.check_copies(32, 64, "--step", "0.25", "--frequency", "0.4", "--origin", "-70,1000")

    def test_rounding(self):
        """Elsewhere but for rounding."""
        self.check_copies(60, 90, "--frequency", "0.1", exact=False)
        self.check_copies(50, 75, "--frequency", "0.21", "--step", "0.3", exact=False)

    def test_is_not_constant(self):
        self.make("one", "--size", "64x64", "--tileable", "--frequency", "0.05")
        self.assertGreater(len(set(self.rows("one.r16", 64, 64)[0])), 40)

    def test_tiles(self):
        """Tiles of a world that repeats are the same as the whole; the manifest tells them apart
        from those of one that does not."""
        options = ["--size", "64x64", "--frequency", "0.06", "--quiet"]
        self.make("whole", *options, "--tileable")
        run("terrain", *options, "--tileable", "--tile", "32x32", "--heights", "t.r16",
            cwd=self.directory, check=True)
        whole = self.rows("whole.r16", 64, 64)
        for y in range(2):
            for x in range(2):
                tile = self.rows("t_%d_%d.r16" % (y, x), 32, 32)
                self.assertEqual(tile, [row[32 * x:32 * x + 32]
                                        for row in whole[32 * y:32 * y + 32]])
        other = run("terrain", *options, "--tile", "32x32", "--heights", "t.r16", "--resume",
                    cwd=self.directory)
        self.assertEqual(other.returncode, 2)

    def test_summary(self):
        result = run("terrain", "--size", "64x32", "--frequency", "0.1", "--tileable", "--heights",
                     "h.r32", cwd=self.directory)
        self.assertIn(b"repeats after 64x32 samples: frequency 0.09375, 6 x 3 cells\n",
                      result.stdout)

    def test_refused(self):
        small = ["terrain", "--size", "64x64", "--heights", "h.r32"]
        for name, words in (
                ("--tileable", ["--tileable", "--period", "8x8"]),
                ("--rotate", ["--tileable", "--rotate"]),
                ("--rotate", ["--period", "8x8", "--rotate"]),
                ("--period", ["--period", "100x99", "--frequency", "0.01"]),
                ("--period", ["--tileable", "--size", "100x99", "--frequency", "0.01"]),
                ("--lacunarity", ["--tileable", "--octaves", "2", "--lacunarity", "2.5"]),
                ("--lacunarity", ["--tileable", "--lacunarity", "0.5"]),
                ("--period", ["--period", "1x1", "--frequency", "2e9"]),
                ("--period", ["--tileable", "--octaves", "32"])):
            with self.subTest(words=words):
                self.refused(name, small + words)
        # Rows of triangles are no whole number of cells apart.
        self.refused("--period", small + ["--tileable", "--basis", "simplex"])
        self.refused("--period", ["sample", "--period", "4,4", "--basis", "simplex"], b"1 2\n")
        for words, points in (("4,0", b"1 2\n"), ("4,4,4", b"1 2 3\n")):
            result = run("sample", "--period", words, "--basis", "simplex", cwd=self.directory,
                         input=points)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
        for words in (["--period", "4,4", "--rotate", "--octaves", "2"],):
            self.refused("--rotate", ["sample"] + words)
        self.refused("--lacunarity", ["sample", "--period", "4,4", "--lacunarity", "2.5",
                                      "--octaves", "2"])
        for text in ("4", "4,", ",4", "4,4,4,4", "4,x", "-1,4", "1073741825,1", "1.5,2"):
            self.refused("--period", ["sample", "--period", text])

    def test_reasons(self):
        """The one line of an error names the option and has the reason of the library."""
        for line, words in (
                ("--rotate: turned axes cannot repeat;", "--period 4,4 --rotate --octaves 2"),
                ("--lacunarity: not a whole number, which octaves with a period need",
                 "--period 4,4 --lacunarity 2.5 --octaves 2"),
                ("--period: more than 2^30 cells in the last octave; fewer --octaves",
                 "--period 4,536870912 --octaves 3"),
                ("--period: simplex noise repeats along x only in 2D; a slice of 3D, with periods, repeats along both; leave it out",
                 "--period 4,4 --basis simplex"),
                ("--frequency, --lacunarity, --octaves: the frequency of the last octave is outside "
                 "[2^-32, 2^48]",
                 "--frequency 1e12 --octaves 20"),
                ("--of-octaves: below octaves", "--of-octaves 2 --octaves 3"),
                ("--erosion: this fractal takes 1 at most", "--fractal jordan --erosion 2"),
                ("--phase: only gradient noise has a phase; ", "--phase 1 --basis value"),
                ("--hessian: this fractal has no Hessian",
                 "--fractal swiss --hessian"),
                ("--dphase: this fractal has no dphase", "--fractal swiss --dphase"),
                ("--dphase: only gradient noise has dphase; ", "--basis value --dphase")):
            with self.subTest(words=words):
                self.refused(line, ["sample"] + words.split(), b"1 2\n", end="")
        self.refused("--rotate: turned axes cannot repeat;", ["terrain", "--rotate", "--octaves", "2",
                     "--size", "8x8", "--tileable", "--heights", "a.r16"], end="")

    def refused(self, name, words, points=b"", end=": "):
        result = run(*words, cwd=self.directory, input=points)
        lines = result.stderr.decode().splitlines()
        self.assertEqual((result.returncode, len(lines)), (2, 1), lines)
        self.assertTrue(lines[0].startswith("scarp: %s%s" % (name, end)), lines)
        self.assertEqual(self.files(), [])

    def test_points(self):
        """`scarp sample` counts in cells."""
        points = b"0.25,0.5,0.125\n4.25,0.5,0.125\n0.25,-5.5,0.125\n0.25,0.5,2.125\n1.25,0.5,0.125\n"
        result = run("sample", "--period", "4,6,1", "--octaves", "3", "--hessian", input=points)
        lines = result.stdout.decode().splitlines()
        self.assertEqual(len(lines), 5)
        self.assertEqual(lines[0:1] * 4, lines[:4])
        self.assertNotEqual(lines[0], lines[4])


common.main(globals())
