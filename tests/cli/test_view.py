# SPDX-License-Identifier: MIT
"""scarp view: pictures of a terrain, and what it refuses."""
import re
import signal
import unittest
import zlib

import common
from common import PATIENCE, Case, has_png, has_threads, run, start, supported_isas
from rasters import read_picture

SMALL = ("--size", "96x54", "--samples", "2")
# Not of a preset, since those may change. The sea, snow, shadows, haze and the sky are in them.
COAST = ("--seed", "3", "--frequency", "0.004", "--octaves", "6", "--sea-level", "-0.05",
         "--height", "150")
PEAKS = ("--fractal", "erosion", "--rotate", "--octaves", "7", "--height", "200",
         "--camera", "0,0,180", "--look", "45,-12")
# Flat ground and cliffs
MESAS = ("--basis", "cell-value", "--frequency", "0.02", "--octaves", "1", "--height", "60",
         "--seed", "12")
COAST_CRC = 0xe25f092b
PEAKS_CRC = 0xf0f3a947
MESAS_CRC = 0xd063c877


class View(Case):
    def view(self, *arguments, name="v.ppm"):
        """Runs `scarp view`, which must succeed in silence; returns the bytes of the picture."""
        result = run("view", *SMALL, *arguments, "--output", name, "--quiet", cwd=self.directory)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""),
                         arguments)
        return self.bytes(name.split(":")[-1])

    def picture(self, *arguments, name="v.ppm"):
        self.view(*arguments, name=name)
        return read_picture(self.path(name))

    def test_bytes(self):
        """The same on every machine."""
        for arguments, checksum in ((COAST, COAST_CRC), (PEAKS, PEAKS_CRC),
                                    (MESAS, MESAS_CRC)):
            with self.subTest(arguments=arguments):
                self.assertEqual("%#010x" % zlib.crc32(self.view(*arguments)),
                                 "%#010x" % checksum)

    def test_instruction_sets_and_threads(self):
        ways = [("--isa", isa) for isa in supported_isas()]
        if has_threads():
            ways += [("--threads", "1"), ("--threads", "2"), ("--threads", "3")]
        expected = self.view(*COAST, "--size", "150x70")
        for way in ways:
            self.assertEqual(self.view(*COAST, "--size", "150x70", *way), expected, way)

    def test_looks_like_a_landscape(self):
        """The sky is above, bluer at the top; no ground is as even as it."""
        picture = self.picture(*PEAKS)
        self.assertEqual(picture.shape(), (96, 54, 3, 8))
        top = picture.rows[0]
        for red, green, blue in top:
            self.assertLess(red, blue)
        bottom = picture.rows[-1]
        spread = [max(p[1] for p in row) - min(p[1] for p in row) for row in (top, bottom)]
        self.assertLess(2 * spread[0], spread[1])

    def test_cliffs(self):
        """They are rock as a whole. Where rays end in front of them or behind them, there are
        stripes, of the grass above and below: 7 changes in each column."""
        rows = self.picture(*MESAS, "--size", "192x108").rows[54:]
        green = [[p[1] > p[0] and p[1] > p[2] for p in row] for row in rows]
        changes = sum(a != b for above, row in zip(green, green[1:])
                      for a, b in zip(above, row))
        self.assertLess(changes, 3 * 192)

    def test_png(self):
        if not has_png():
            self.skipTest("needs zlib")
        self.check_rows(self.picture(*COAST, name="v.png").rows, self.picture(*COAST).rows)
        self.view("--size", "7x5", name="png:other.dat")
        self.assertEqual(read_picture(self.path("other.dat"), "png").shape(), (7, 5, 3, 8))

    def test_arrays(self):
        expected = self.picture().rows
        for name in ("v.npy", "v.img", "v.tif"):
            self.check_rows(self.picture(name=name).rows, expected)
        wide = ("--size", "300x280", "--samples", "1", "--octaves", "2")  # four tiles of TIFF
        self.check_rows(self.picture(*wide, name="v.tif").rows, self.picture(*wide).rows)

    def test_sizes(self):
        """Also those that tiles and their parts do not divide."""
        for size in ("1x1", "3x200", "129x65", "128x64"):
            width, height = map(int, size.split("x"))
            picture = self.picture("--size", size, "--samples", "1", "--octaves", "2")
            self.assertEqual(picture.shape(), (width, height, 3, 8))

    def test_tiles_have_no_edges(self):
        """Pixels on both sides of where tiles meet differ no more than others do."""
        rows = self.picture("--size", "160x70", "--camera", "0,0,3000", "--look", "0,-80",
                            "--octaves", "1", "--frequency", "0.0002", "--samples", "1").rows

        def step(column):
            return sum(abs(row[column][1] - row[column - 1][1]) for row in rows)
        self.assertLessEqual(step(128), 2 * max(step(127), step(129), 20))

    def test_every_option_counts(self):
        expected = self.view(*PEAKS)
        for more in (("--sun", "90,40"), ("--haze", "0"), ("--haze", "500"), ("--fov", "30"),
                     ("--samples", "5"), ("--look", "50,-12"), ("--camera", "0,0,190"),
                     ("--seed", "9"), ("--origin", "5000,0"), ("--scale", "2"),
                     ("--sea-level", "0.1"), ("--plateau", "0.2")):
            self.assertNotEqual(self.view(*PEAKS, *more), expected, more)

    def test_palettes(self):
        """Each has colours of its own; a preset has one; a file has those of heights."""
        with open(self.path("red.txt"), "w", encoding="utf-8") as file:
            file.write("0% 255 0 0\n100% 250 5 5\n")
        with open(self.path("steps.txt"), "w", encoding="utf-8") as file:
            file.write("0% 0 255 0\n30% 0 250 0\n40% 255 0 0\n100% 250 5 5\n")
        names = ("alpine", "temperate", "desert", "arctic", "grey", "red.txt", "steps.txt")
        pictures = {name: self.view(*PEAKS, "--palette", name) for name in names}
        self.assertEqual(len(set(pictures.values())), len(names))
        self.assertEqual(pictures["alpine"], self.view(*PEAKS))
        with open(self.path("sand.recipe"), "w", encoding="utf-8") as file:
            file.write("#: palette desert\n" + common.text_of("terrain", *PEAKS[:-4],
                                                              "--print-recipe"))
        self.assertEqual(self.view(*PEAKS[-4:], "--recipe", "sand.recipe"), pictures["desert"])
        for red, green, _ in self.picture(*PEAKS, "--haze", "0", "--palette", "red.txt").rows[-1]:
            self.assertGreaterEqual(red, green)

    def test_closing_lines(self):
        """The camera is printed as options, which give the same picture again."""
        result = run("view", *SMALL, "--output", "v.ppm", cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        text = result.stdout.decode()
        camera = re.search(r"(?m)^camera: (--camera \S+ --look \S+)$", text).group(1).split()
        self.assertEqual(self.bytes("v.ppm"), self.view(*camera))
        self.assertRegex(text, r"(?m)^96x54 pixels, \d+\.\d thousand rays in \d+\.\d+ m?s: ")
        for what in ("marching", "shadows", "light"):
            self.assertRegex(text, r"(?m)^%s: \d+\.\d (?:thousand|million) points in \d+ calls" % what)

    def test_standard_output(self):
        result = run("view", *SMALL, "--output", "ppm:-")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stdout, self.view())
        self.assertIn(b"96x54 pixels", result.stderr)

    def test_default_camera_is_above_the_ground(self):
        for seed in range(1, 6):
            for more in ((), ("--fractal", "ridged", "--height", "300"), ("--height", "0"),
                         ("--origin", "-123456,7891011"), ("--sea-level", "2")):
                self.view("--size", "8x6", "--seed", str(seed), *more)

    def test_extremes(self):
        """Whatever the numbers are, there is a picture, soon."""
        for more in (("--height", "16777216"), ("--height", "0"), ("--fov", "150"),
                     ("--fov", "1", "--size", "40x3"), ("--frequency", "1e-6"),
                     ("--frequency", "5000", "--octaves", "12"), ("--octaves", "32"),
                     ("--height", "16777216", "--amplitude", "16777216", "--frequency", "1000"),
                     ("--camera", "0,0,16777216", "--look", "0,-89"),
                     ("--camera", "1e12,-1e12,500", "--look", "360,89"),
                     ("--sun", "0,90"), ("--sun", "360,1"), ("--sea-level", "3"),
                     ("--plateau", "-2"), ("--haze", "16777216"), ("--haze", "1")):
            self.view("--size", "12x7", *more)

    @unittest.skipIf(common.pty is None, "needs POSIX")
    def test_progress(self):
        status, shown = self.on_terminal("view", "--size", "300x200", "--samples", "1",
                                         "--output", "v.ppm", cwd=self.directory)
        self.assertEqual(status, 0)
        self.assertTrue(shown.startswith("0...10...20...30...40...50...60...70...80...90...100 - "
                                         "done."), shown)

    @unittest.skipIf(common.signal is None, "needs POSIX")
    def test_interrupt(self):
        process = start("view", "--size", "4000x4000", "--samples", "256", "--output", "v.ppm",
                        cwd=self.directory)
        self.wait_for_unfinished("v.ppm")
        process.send_signal(signal.SIGINT)
        _, error = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertRegex(error.decode(), r"\Ascarp: interrupted: [^\n]*\n\Z")
        self.assertEqual(self.files(), [])


class ViewRefused(Case):
    def check(self, *arguments, words):
        result = run("view", *SMALL, *arguments, cwd=self.directory)
        self.check_one_line(result, 2, *words)
        self.assertEqual(self.files(), [])

    def test_output(self):
        self.check(words=("--output", "must be given"))
        for name in ("v", "v.jpg", "v.r16", "v.r32", "v.pfm", "v.pgm", ".ppm.part", "png:", ""):
            self.check("--output", name, words=("--output",))
        self.check("--output", "none/v.ppm", words=("--output", "none/v.ppm"))

    def test_values(self):
        for option, values in {
                "--size": ("0x5", "5", "16385x2", "2x16385", "axb"),
                "--samples": ("0", "257", "1.5", ""),
                "--camera": ("1,2", "1,2,3,4", "a,0,0", "0,0,1e9", "2e12,0,0", "0,0,nan", ""),
                "--look": ("10", "-1,0", "361,0", "0,90", "0,-89.5", "0,0,0", "x,0"),
                "--fov": ("0.9", "151", "wide", "nan"),
                "--sun": ("10", "-1,20", "361,20", "90,0.5", "90,91"),
                "--haze": ("-1", "0.5", "2e7", "thick"),
                "--origin": ("0", "0,2e12", "0,0,0"),
                "--threads": ("0", "1025"),
                "--isa": ("best",),
                "--preset": ("moon",)}.items():
            for value in values:
                self.check("--output", "v.ppm", option, value, words=(option,))

    def test_palette(self):
        self.check("--output", "v.ppm", "--palette", "none.txt", words=("--palette", "none.txt"))
        with open(self.path("bad.txt"), "w", encoding="utf-8") as file:
            file.write("0 1 2 3\n5 blue\nx\n")
        result = run("view", *SMALL, "--output", "v.ppm", "--palette", "bad.txt",
                     cwd=self.directory)
        self.check_one_line(result, 2, "--palette", "bad.txt", "3")
        self.assertEqual(self.files(), ["bad.txt"])

    def test_camera_under_the_ground(self):
        """The height of the ground is printed, and is where the camera may not be."""
        self.check("--output", "v.ppm", "--camera", "512,512,-100", words=("--camera", "-100"))
        error = run("view", *SMALL, "--output", "v.ppm", "--camera", "512,512,-100",
                    cwd=self.directory).stderr.decode()
        ground = re.search(r"which is (\S+) high", error).group(1)
        self.check("--output", "v.ppm", "--camera", "512,512," + ground, words=("--camera", ground))
        above = "%r" % (float(ground) + 0.01)
        result = run("view", *SMALL, "--output", "v.ppm", "--camera", "512,512," + above, "--quiet",
                     cwd=self.directory)
        self.assertEqual(result.returncode, 0)

    def test_terrain_options(self):
        """What scarp terrain refuses of its terrain, scarp view refuses, too."""
        for arguments, words in ((("--plateau", "-1", "--sea-level", "0"), ("--plateau",)),
                                 (("--warp-gain", "0.3"), ("--warp-gain", "recipe")),
                                 (("--frequency", "0"), ("--frequency",)),
                                 (("--heights", "h.png"), ("--heights",))):
            self.check("--output", "v.ppm", *arguments, words=words)


common.main(globals())
